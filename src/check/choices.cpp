// SPDX-License-Identifier: BSD-3-Clause
#include "check/choices.hpp"

#include "scene/build_scene.hpp"
#include "scene/dormant.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace barreno {

Choice pore_flow_choice(const Scene& scene) {
  const PoreFlowSpec& flow = scene.pore_flow;
  if (flow.rocks.empty()) return {false, "no Pore Flow list: undrained"};
  const double length = drained_length(scene), cells = length / scene.grid.cell_size;
  const bool matters = cells >= shortest_drained_length;
  const char* const verdict = flow.on() ? (matters ? "" : "; Drainage is on nevertheless")
                              : matters ? "; Drainage is off"
                                        : ": negligible (Drainage = on forces it)";
  char text[160];
  std::snprintf(
      text,
      sizeof text,
      "pressure diffuses %.3g m in the run, %.2g cells (limit %g)%s",
      length,
      cells,
      shortest_drained_length,
      verdict
  );
  return {flow.on(), text};
}

Choice dormancy_choice(const Scene& scene) {
  if (!scene.step.skip_dormant) return {false, "Skip Dormant Tiles is false"};
  const std::string why = why_all_awake(scene);
  if (!why.empty()) return {false, why};
  const double motion = rest_motion(scene);
  if (motion == 0.0)
    return {true, "dormant tiles are skipped: the answer is the same, bit for bit"};
  char text[120];
  std::snprintf(
      text, sizeof text, "dormant tiles are skipped until a node moves %.2g cells in a step", motion
  );
  return {true, text};
}

Choice refinement_choice(const Scene& scene) {
  const GridSpec& grid = scene.grid;
  const int finest = finest_level(grid);
  if (finest == 0)
    return {false, "no Refinement list, and Jet/Cells Per Radius is 0: all cells have Cell Size"};
  const auto tiles = static_cast<double>(grid.level_of_tile.size());
  std::string text = "cells of";
  for (int level = 0; level <= finest; ++level) {
    const auto count = std::count(grid.level_of_tile.begin(), grid.level_of_tile.end(), level);
    char part[80];
    std::snprintf(
        part,
        sizeof part,
        "%s %g m in %.3g %%",
        level == 0 ? "" : ",",
        uniform_grid(grid, level).cell_size,
        100.0 * static_cast<double>(count) / tiles
    );
    text += part;
  }
  return {true, text + " of the box"};
}

Choice quasi_static_choice(const Scene& scene) {
  const QuasiStaticSpec& slow = scene.quasi_static;
  if (!slow.on()) return {false, "no Quasi-Static list: true inertia"};
  char text[200];
  std::snprintf(
      text,
      sizeof text,
      "inertia x %.3g: waves cross in %.3g s, %.2g of the %.3g s of diffusion; damping %.3g 1/s",
      slow.inertia_factor,
      slow.transit_time,
      slow.transit_time / slow.slow_time,
      slow.slow_time,
      scene.step.damping
  );
  return {true, text};
}

}  // namespace barreno
