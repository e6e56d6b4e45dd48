// SPDX-License-Identifier: BSD-3-Clause
#include "jet/path.hpp"

#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "scene/materials/liquids.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// Extent of a body on the axis; empty (lower > upper) if it does not reach it.
struct Extent {
  double lower = infinity, upper = -infinity;
};
/// Where a shape begins and ends in the column around the axis: halving, because what a slice from
/// one of its ends on holds only grows.
Extent in_column(const Shape& shape, Box column, double radius, int dimension) {
  for (const std::size_t across : {0U, 2U}) {
    column.lower[across] = std::max(column.lower[across], -radius);
    column.upper[across] = std::min(column.upper[across], radius);
    if (across < static_cast<std::size_t>(dimension) &&
        column.upper[across] <= column.lower[across])
      return {};
  }
  const auto holds_some = [&](double from, double to) {
    Box slice = column;
    slice.lower[1] = from;
    slice.upper[1] = to;
    return piece_of(shape, slice, dimension).measure > 0.0;
  };
  const double from = column.lower[1], to = column.upper[1];
  if (!holds_some(from, to)) return {};
  Extent extent{from, to};
  double end = to, begin = from;
  for (int halving = 0; halving < 40; ++halving) {
    const double lower = 0.5 * (extent.lower + end), upper = 0.5 * (begin + extent.upper);
    (holds_some(from, lower) ? end : extent.lower) = lower;
    (holds_some(upper, to) ? begin : extent.upper) = upper;
  }
  return extent;
}

Extent on_axis(const Shape& shape, const GridSpec& grid, double radius) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    const auto reaches = [&](std::size_t across) {
      return box->lower[across] < radius && box->upper[across] > -radius;
    };
    const bool meets = reaches(0) && (dimensions(grid.mode) == 2 || reaches(2));
    return meets ? Extent{box->lower[1], box->upper[1]} : Extent{};
  }
  if (const auto* ball = std::get_if<Ball>(&shape)) {
    if (std::hypot(ball->centre[0], ball->centre[2]) - ball->radius >= radius) return {};
    return {ball->centre[1] - ball->radius, ball->centre[1] + ball->radius};
  }
  return in_column(shape, box_around(shape, grid), radius, dimensions(grid.mode));
}

/// The channel is measured with the smallest cells of the grid, so that larger ones elsewhere do
/// not change its measure.
double finest_cell(const GridSpec& grid) {
  unsigned char level = 0;
  for (const unsigned char one : grid.level_of_tile) level = std::max(level, one);
  return grid.cell_size / (1 << level);
}

/// Bodies that a jet meets, the nearest first.
std::vector<PathLayer> layers_ahead(const Scene& scene, const JetOrigin& origin) {
  const double start = origin.direction * origin.plane + length_tolerance(scene.grid);
  const bool forward = origin.direction > 0.0;
  std::vector<PathLayer> layers;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (is_jet_body(origin, static_cast<int>(b))) continue;
    const Extent extent = on_axis(scene.bodies[b].shape, scene.grid, origin.radius);
    const double near = forward ? extent.lower : -extent.upper;
    const double far = forward ? extent.upper : -extent.lower;
    if (!(far > near) || far <= start) continue;  // off the axis or behind the jet
    const auto material = static_cast<std::size_t>(scene.bodies[b].material);
    layers.push_back({b, near, far, is_liquid(scene.materials[material])});
  }
  std::stable_sort(layers.begin(), layers.end(), [](const PathLayer& a, const PathLayer& b) {
    return a.near < b.near;
  });
  return layers;
}

}  // namespace

bool is_jet_body(const JetOrigin& origin, int body) {
  return std::find(origin.bodies.begin(), origin.bodies.end(), body) != origin.bodies.end();
}

double widest_radius(const Scene& scene) {
  double radius = 0.0;
  for (const JetSlug& slug : scene.jet.slugs) radius = std::max(radius, slug.radius);
  return radius;
}

double depth_in(const PathLayer& layer, const JetPath& path, double depth) {
  return std::clamp(depth - (layer.near - path.direction * path.face), 0.0, layer.far - layer.near);
}

std::vector<PathLayer> path_layers(const Scene& scene, double radius) {
  JetOrigin origin = launched_jet(scene);
  origin.radius = radius;
  return layers_ahead(scene, origin);
}

std::vector<PathLayer> solid_layers(std::vector<PathLayer> layers) {
  layers.erase(
      std::remove_if(
          layers.begin(), layers.end(), [](const PathLayer& layer) { return layer.liquid; }
      ),
      layers.end()
  );
  return layers;
}

const BodySpec& longest_body(const Scene& scene, const std::vector<PathLayer>& layers) {
  const auto longest =
      std::max_element(layers.begin(), layers.end(), [](const PathLayer& a, const PathLayer& b) {
        return a.far - a.near < b.far - b.near;
      });
  return scene.bodies[longest->body];
}

const BodySpec* longest_solid(const Scene& scene) {
  const std::vector<PathLayer> solids = solid_layers(path_layers(scene, widest_radius(scene)));
  return solids.empty() ? nullptr : &longest_body(scene, solids);
}

JetOrigin launched_jet(const Scene& scene) {
  JetOrigin origin;
  origin.bodies = {static_cast<int>(scene.bodies.size())};
  origin.plane = scene.jet.launch_position;
  origin.direction = scene.jet.direction;
  origin.radius = widest_radius(scene);
  origin.mass = jet_table_totals(scene, scene.jet.slugs.size()).mass;
  return origin;
}

JetOrigin formed_jet(const Scene& scene, const JetMonitorSpec& monitor) {
  JetOrigin origin;
  origin.bodies = monitor.bodies;
  origin.plane = monitor.position;
  origin.direction = monitor.direction;
  origin.formed = true;
  // How wide it will be is not known: what lies on the axis.
  origin.radius = scene.grid.cell_size;
  const double ring = scene.grid.mode == Mode::axisymmetric ? two_pi * scene.grid.upper[0] : 1.0;
  for (const int body : monitor.bodies)
    origin.mass += ring * monitor.density *
                   max_measure(scene.bodies[static_cast<std::size_t>(body)].shape, scene.grid);
  return origin;
}

JetPath jet_path(const Scene& scene) {
  return jet_path(scene, launched_jet(scene));
}

std::optional<JetPath> recorded_path(const Scene& scene, const JetMonitorSpec& monitor) {
  if (scene.jet.present) return jet_path(scene);
  if (!monitor.present()) return {};
  JetPath path = jet_path(scene, formed_jet(scene, monitor));
  if (!path.has_target) return {};
  return path;
}

JetPath jet_path(const Scene& scene, const JetOrigin& origin) {
  JetPath path;
  path.origin = origin;
  path.direction = origin.direction;
  path.bin = finest_cell(scene.grid);
  const double launch = path.direction * origin.plane;
  double face = infinity, end = -infinity;
  for (const PathLayer& layer : layers_ahead(scene, origin)) {
    if (layer.liquid) {
      path.liquid += layer.far - layer.near;
      continue;
    }
    face = std::min(face, layer.near);
    end = std::max(end, layer.far);
  }
  path.has_target = end >= face;
  if (!path.has_target) face = end = launch;
  path.face = path.direction * face;
  path.end = path.direction * end;
  constexpr double round_off = 1e-9;
  path.bins = static_cast<int>(std::ceil((end - face) / path.bin - round_off));
  return path;
}

}  // namespace barreno
