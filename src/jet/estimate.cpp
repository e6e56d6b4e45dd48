// SPDX-License-Identifier: BSD-3-Clause
#include "jet/estimate.hpp"

#include "base/numbers.hpp"
#include "jet/divided_error.hpp"
#include "jet/kinds.hpp"
#include "jet/path.hpp"
#include "jet/rest.hpp"
#include "scene/jet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace barreno {
namespace {

/// The bottom of the hole: where it is along the jet's direction, and when the jet is there.
struct Bottom {
  double place = 0.0, time = 0.0;
  bool passed = false;
};

class Target {
public:
  explicit Target(const Scene& scene)
      : scene_(scene),
        layers_(path_layers(scene, widest_radius(scene))),
        solids_(solid_layers(layers_)) {}

  bool empty() const { return solids_.empty(); }
  /// Where the jet begins to dig, in a liquid too.
  double start() const { return layers_.front().near; }
  /// Length dug in solids and what is between them [length].
  double depth(double place) const { return std::max(0.0, place - solids_.front().near); }

  /// Lets a slug dig until it is consumed, has come through the target, or the time is over.
  /// @return the length of it that is left [length]
  double dig(const JetSlug& slug, double until, Bottom& bottom) const {
    double left = slug.length;
    for (const PathLayer& layer : layers_) {
      if (layer.far <= bottom.place) continue;
      if (bottom.place < layer.near) {  // free flight through a gap
        bottom.time += (layer.near - bottom.place) / slug.velocity;
        bottom.place = layer.near;
      }
      const double k = std::sqrt(density_of(layer) / digging_density_of(slug));
      const double consumption = slug.velocity * k / (1.0 + k);
      const double through = (layer.far - bottom.place) * k;
      const double used =
          std::min({left, through, consumption * std::max(0.0, until - bottom.time)});
      left -= used;
      bottom.time += used / consumption;
      if (used < through) {
        bottom.place += used / k;
        return left;
      }
      bottom.place = layer.far;
    }
    bottom.passed = true;
    return left;
  }

private:
  double density_of(const PathLayer& layer) const {
    return scene_.materials[static_cast<std::size_t>(scene_.bodies[layer.body].material)].density();
  }

  double digging_density_of(const JetSlug& slug) const {
    const JetSpec& jet = scene_.jet;
    const double own = scene_.materials[static_cast<std::size_t>(jet.material)].density();
    return digging_density(jet.kind, slug, own);
  }

  const Scene& scene_;
  std::vector<PathLayer> layers_, solids_;
};

/// Mass over density, pi and the thickness of a plane.
double volume_of(const Scene& scene, const JetSlug& slug, double length) {
  return slug.radius * length * (scene.grid.mode == Mode::plane_strain ? 1.0 : slug.radius);
}

}  // namespace

namespace {

/// Share of the flight that a slug fills until the next one; the last one's is that before it.
double filled_share(const std::vector<JetSlug>& slugs, std::size_t i) {
  if (slugs.size() < 2) return 1.0;
  const std::size_t first = std::min(i, slugs.size() - 2);
  const double way = slugs[i].velocity * (slugs[first + 1].time - slugs[first].time);
  return way > slugs[i].length ? slugs[i].length / way : 1.0;
}

/// What the measurements ask of slugs that dig.
void note_slug(const std::vector<JetSlug>& slugs, std::size_t i, JetEstimate& result) {
  const JetSlug& slug = slugs[i];
  const bool first = result.thinnest == 0.0;
  if (first || slug.radius < result.thinnest) {
    result.thinnest = slug.radius;
    result.length = slug.length;
  }
  if (first || slug.velocity < result.slowest) result.slowest = slug.velocity;
  result.least_filled = std::min(result.least_filled, filled_share(slugs, i));
}

}  // namespace

JetEstimate estimate_jet(const Scene& scene, double until, double slowest) {
  JetEstimate result;
  const Target target(scene);
  if (target.empty()) return result;
  const double launch = scene.jet.direction * scene.jet.launch_position;
  Bottom bottom{target.start(), 0.0, false};
  double mass = 0.0, energy = 0.0, mass_left = 0.0, energy_left = 0.0;
  const std::vector<JetSlug>& slugs = scene.jet.slugs;
  for (std::size_t i = 0; i < slugs.size(); ++i) {
    const JetSlug& slug = slugs[i];
    const double way = std::max(0.0, bottom.place - launch - 0.5 * slug.length);
    const double start = std::max(bottom.time, slug.time + way / slug.velocity);
    double left = slug.length;
    if (start < until && !bottom.passed && slug.velocity >= slowest) {
      bottom.time = start;
      left = target.dig(slug, until, bottom);
      result.time = bottom.time;
      note_slug(slugs, i, result);
    }
    const double square = slug.velocity * slug.velocity;
    mass += volume_of(scene, slug, slug.length);
    energy += volume_of(scene, slug, slug.length) * square;
    mass_left += volume_of(scene, slug, left);
    energy_left += volume_of(scene, slug, left) * square;
  }
  result.depth = target.depth(bottom.place);
  result.passed = bottom.passed;
  result.mass_left = mass_left / mass;
  result.energy_left = energy_left / energy;
  return result;
}

double first_arrival(const Scene& scene, const JetPath& path) {
  double first = infinity;
  for (const JetSlug& slug : scene.jet.slugs) {
    const double way = std::abs(path.face - scene.jet.launch_position) - 0.5 * slug.length;
    first = std::min(first, slug.time + std::max(0.0, way) / slug.velocity);
  }
  return first;
}

double predicted_rest(const Scene& scene) {
  const JetPath path = jet_path(scene);
  if (!path.has_target) return 0.0;
  const JetEstimate estimate = estimate_jet(scene, infinity, cut_off_velocity(scene));
  const RestRule rule = rest_rule(scene);
  const double first = first_arrival(scene, path);
  const double unchanged = (estimate.time - rest_window * first) / (1.0 - rest_window);
  const double depth = (is_divided(scene) ? divided_depth_ratio : 1.0) * estimate.depth;
  double rest = std::max(estimate.time + rule.least_window, unchanged);
  for (const ComingSlug& slug : rule.slugs)
    rest = std::max(rest, slug.time + (rule.stand_off + depth) / (slowed * slug.velocity));
  return rest;
}

double expected_end(const Scene& scene) {
  return scene.at_rest ? std::min(scene.end_time, predicted_rest(scene)) : scene.end_time;
}

SlugCells slug_cells(const Scene& scene, double JetSlug::*length) {
  const std::vector<JetSlug>& slugs = scene.jet.slugs;
  const double cell_size = cell_size_of_path(scene);
  const auto cells = [&](const JetSlug& slug) { return slug.*length / cell_size; };
  SlugCells result{cells(slugs.front()), cells(slugs.back()), cells(slugs.front()), 0.0};
  for (const JetSlug& slug : slugs) {
    result.least = std::min(result.least, cells(slug));
    result.most = std::max(result.most, cells(slug));
  }
  return result;
}

DepthDoubt depth_doubt(const Scene& scene, double time, double depth, const DepthTables& tables) {
  if (is_divided(scene)) return divided_depth_doubt(scene, time, tables);
  const JetEstimate estimate = estimate_jet(scene, time);
  DepthDoubt doubt;
  doubt.cells_per_radius = estimate.thinnest / cell_size_of_path(scene);
  doubt.cells_per_length = estimate.length / cell_size_of_path(scene);
  if (estimate.thinnest == 0.0) {
    doubt.unknown = "the jet does not reach a target by then";
    return doubt;
  }
  doubt.unknown = why_depth_error_unknown(tables, scene, doubt.cells_per_radius);
  const double shape = estimate.length / estimate.thinnest;
  if (doubt.unknown.empty()) {
    const JetSlug& tip = scene.jet.slugs.front();
    doubt.unknown =
        why_reach_unknown(tables, time - tip.time, estimate.thinnest, tip.velocity, depth);
  }
  if (doubt.unknown.empty())
    doubt.unknown = why_slugs_unknown(tables, shape, estimate.slowest, estimate.least_filled);
  if (!doubt.unknown.empty()) return doubt;
  const DepthOf whose = depth > 0.0 ? DepthOf::run : DepthOf::estimate;
  const double reached = whose == DepthOf::run ? depth : estimate.depth;
  doubt.error =
      measured_depth_error(tables, doubt.cells_per_radius, reached / estimate.thinnest, whose);
  doubt.error = with_length(tables, doubt.error, doubt.cells_per_radius, shape);
  return doubt;
}

DepthDoubt depth_doubt(const Scene& scene, double time, const Penetration& found) {
  DepthDoubt doubt;
  doubt.unknown = "it was measured with launched jets only";
  if (!scene.jet.present) return doubt;
  doubt = depth_doubt(scene, time, found.depth);
  if (found.through) doubt.unknown = "the jet has come out of the rear of the target";
  return doubt;
}

std::string depth_doubt_text(const DepthDoubt& doubt) {
  if (!doubt.unknown.empty()) return "unknown (" + doubt.unknown + "); " + unknown_error_advice;
  char cells[96];
  const bool one = std::abs(doubt.cells_per_radius - 1.0) < 0.005;
  std::snprintf(
      cells,
      sizeof cells,
      " at %.2g cell%s per jet radius and %.2g per slug length, as ",
      doubt.cells_per_radius,
      one ? "" : "s",
      doubt.cells_per_length
  );
  return depth_error_text(doubt.error) + cells + depth_error_source;
}

}  // namespace barreno
