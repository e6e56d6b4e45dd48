// SPDX-License-Identifier: BSD-3-Clause
#include "check/body_steps.hpp"

#include "check/awake_parts.hpp"
#include "check/predict_cost.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace barreno {
namespace {

double widest_slug(const Scene& scene) {
  double widest = 0.0;
  for (const JetSlug& slug : scene.jet.slugs) widest = std::max(widest, slug.radius);
  return widest;
}

/// Whether the jet passes through the tile of a place.
bool shares_tile_with_jet(const Scene& scene, const AwakePart& part) {
  if (!scene.jet.present) return false;
  const double radius = widest_slug(scene);
  const double tile = tile_size_of(scene.grid) / (1 << part.level);
  bool shares = true;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(scene.grid.mode)); d += 2) {
    const auto index = [&](double x) { return std::floor((x - scene.grid.lower[d]) / tile); };
    shares = shares && index(part.x[d]) >= index(-radius) && index(part.x[d]) <= index(radius);
  }
  return shares;
}

/// Exponent of the parts that a tile takes at once, a power of two.
int length_within(double stable, double dt, int most) {
  int length = 0;
  while ((2 << length) <= most && (2 << length) * dt <= stable) ++length;
  return length;
}

/// @param stable  step of the body's material in the smallest cells [time]
/// @param steps   that its particles would take in all
void add_body(
    const Scene& scene, const BodySpec& body, double stable, double dt, double steps, BodySteps& sum
) {
  const int finest = finest_level(scene.grid);
  std::vector<AwakePart> parts;
  double particles = 0.0;
  const bool alike = scene.grid.level_of_tile.empty() && scene.step.subcycles == 1 &&
                     !foresees_dormancy(scene);  // one part stands for all, and none is looked for
  if (!alike)
    for_each_awake_part(scene, body, dt, [&](const AwakePart& part) {
      parts.push_back(part);
      particles += part.particles;
    });
  if (parts.empty()) {  // thinner than the coarse cells that stand for those of the run
    parts.push_back({{}, 0, 1.0, 1.0});
    particles = 1.0;
  }
  sum.all += steps;
  for (const AwakePart& part : parts) {
    const double in_its_cells = stable * (1 << (finest - part.level));
    const int length = shares_tile_with_jet(scene, part)
                           ? 0
                           : length_within(in_its_cells, dt, scene.step.subcycles);
    const double awake = steps * part.awake * (part.particles / particles);
    const double taken = awake / (1 << length);
    sum.awake += awake;
    sum.taken += taken;
    sum.shares.of_level[part.level] += taken;
    sum.shares.of_length[length] += taken;
  }
}

}  // namespace

BodySteps steps_of_bodies(const Scene& scene, const std::vector<long long>& counts, double dt) {
  const std::vector<double> stable = stable_steps_of_materials(scene, true);
  BodySteps sum;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodySpec& body = scene.bodies[b];
    if (scene.bodies.size() > 1 && body.motion.prescribed) continue;
    const double steps = static_cast<double>(counts[b]) * scene.end_time / dt;
    add_body(scene, body, stable[static_cast<std::size_t>(body.material)], dt, steps, sum);
  }
  return sum;
}

}  // namespace barreno
