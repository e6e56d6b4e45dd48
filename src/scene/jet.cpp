// SPDX-License-Identifier: BSD-3-Clause
#include "scene/jet.hpp"

#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace barreno {
namespace {

std::string number_text(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", x);
  return buffer;
}

/// What is wrong with one slug, or nothing.
std::string problem_of(const JetSlug& slug, double material_density) {
  const auto positive = [](const char* name, double value, const char* unit) {
    return "a " + std::string(name) + " of " + number_text(value) + " " + unit +
           " (it must be above 0); correct the table";
  };
  if (slug.time < 0.0) {
    return "a launch time of " + number_text(slug.time) +
           " s (the run starts at 0); shift the table";
  }
  if (!(slug.velocity > 0.0)) return positive("velocity", slug.velocity, "m/s");
  if (slug.velocity >= speed_of_light)
    return "a velocity of " + number_text(slug.velocity) +
           " m/s, which is not below the speed of light (" + number_text(speed_of_light) +
           " m/s); look for a wrong unit in the table";
  if (!(slug.radius > 0.0)) return positive("radius", slug.radius, "m");
  if (!(slug.length > 0.0)) return positive("length", slug.length, "m");
  if (!(slug.density > 0.0)) return positive("density", slug.density, "kg/m3");
  // A thousandth allows for the digits of a table.
  if (slug.density > 1.001 * material_density) {
    return "a density of " + number_text(slug.density) + " kg/m3 above the " +
           number_text(material_density) +
           " kg/m3 of its material (only void can be added, not mass); correct the table or the "
           "Material";
  }
  return {};
}

}  // namespace

double fastest_velocity(const JetSpec& jet) {
  double fastest = 0.0;
  for (const JetSlug& slug : jet.slugs) fastest = std::max(fastest, slug.velocity);
  return fastest;
}

double cut_off_velocity(const Scene& scene) {
  // Of the slugs that arrive when the hole of the main job has stopped growing (docs/jets.md).
  constexpr double share = 0.2;
  return scene.cut_off_velocity.value_or(share * fastest_velocity(scene.jet));
}

RefinedRegion path_of_jet(const GridSpec& grid, const JetSpec& jet) {
  constexpr double path_radius = 2.5;
  double thinnest = std::numeric_limits<double>::infinity(), widest = 0.0;
  for (const JetSlug& slug : jet.slugs) {
    thinnest = std::min(thinnest, slug.radius);
    widest = std::max(widest, slug.radius);
  }
  const double ratio = jet.cells_per_radius * grid.cell_size / thinnest;
  const double halvings = ratio > 1.0 ? std::ceil(std::log2(ratio) - 1e-9) : 0.0;
  Box path{grid.lower, grid.upper};
  for (const std::size_t across : {0U, 2U}) {
    path.lower[across] = std::max(path.lower[across], -path_radius * widest);
    path.upper[across] = std::min(path.upper[across], path_radius * widest);
  }
  return {path, static_cast<int>(std::min(halvings, 100.0))};
}

double cell_size_of_path(const Scene& scene) {
  const GridSpec& grid = scene.grid;
  const double launch = scene.jet.launch_position;
  double end = launch;
  for (const BodySpec& body : scene.bodies) {
    const Box around = box_around(body.shape, grid);
    end =
        scene.jet.direction > 0.0 ? std::max(end, around.upper[1]) : std::min(end, around.lower[1]);
  }
  int level = level_at(grid, {0.0, launch, 0.0});
  const double step = scene.jet.direction * grid.cell_size;  // shorter than any tile of level 0
  for (double y = launch; scene.jet.direction * (end - y) > 0.0; y += step)
    level = std::min(level, level_at(grid, {0.0, y, 0.0}));
  return uniform_grid(grid, level).cell_size;
}

GridSpec grid_of_jet(const GridSpec& grid, const JetSpec& jet) {
  return uniform_grid(grid, level_at(grid, {0.0, jet.launch_position, 0.0}));
}

std::vector<JetSlug> table_slugs(
    const std::vector<std::vector<double>>& rows, double material_density, std::string& problem
) {
  std::vector<JetSlug> slugs;
  for (const auto& row : rows) {
    const JetSlug slug{row[0], row[1], row[2], row[3], row[4]};
    const std::string number = std::to_string(slugs.size() + 1);
    const std::string wrong = problem_of(slug, material_density);
    if (!wrong.empty()) {
      problem = "gives slug ";
      problem.append(number).append(" ").append(wrong);
      return {};
    }
    if (!slugs.empty() && slug.time < slugs.back().time) {
      problem = "launches slug " + number + " at " + number_text(slug.time) + " s, before slug " +
                std::to_string(slugs.size()) + " at " + number_text(slugs.back().time) +
                " s (launch times must not decrease); sort the rows by time";
      return {};
    }
    slugs.push_back(slug);
  }
  return slugs;
}

}  // namespace barreno
