// SPDX-License-Identifier: BSD-3-Clause
#include "state/bodies/box_divisions.hpp"

#include "base/numbers.hpp"
#include "scene/tile_levels.hpp"
#include "shape/cpdi.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

namespace {

/// Of a particle, the least that a cut at a cell's line leaves: thinner ones would need small steps
/// where they fly alone.
constexpr double least_part_at_cells = 1.0 / 16.0;

}  // namespace

Division divide(double lower, double upper, double wanted, double cell_size) {
  const double length = upper - lower;
  const auto fewest = static_cast<long long>(std::ceil(length / cell_size - 1e-9));
  const long long n = std::max({1LL, fewest, std::llround(length / wanted)});
  return {lower, (upper - lower) / static_cast<double>(n), n};
}

long long count_places(const Divisions& divisions) {
  const auto& along = divisions.along;
  return along[0].count * along[1].count * along[2].count;
}

NewParticle particle_at(const GridSpec& grid, const Divisions& divisions, const PlaceIndex& index) {
  NewParticle p;
  p.volume = 1.0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d) {
    const Division& division = divisions.along[d];
    p.x[d] = division.centre(index[d]);
    p.half[d] = 0.5 * division.size;
    p.volume *= division.size;
    if (index[d] == 0) p.loaded_sides |= 1U << (2 * d);
    if (index[d] == division.count - 1) p.loaded_sides |= 1U << (2 * d + 1);
  }
  if (grid.mode == Mode::axisymmetric) p.volume *= two_pi * p.x[0];
  return p;
}

BoxCuts box_cuts(const Scene& scene) {
  return scene.step.shape == Cpdi::word ? BoxCuts::at_cells : BoxCuts::at_tiles;
}

double wanted_size(const GridSpec& grid, const BodySpec& body) {
  return grid.cell_size / body.particles_per_cell;
}

namespace {

Divisions divide_box(const GridSpec& grid, const BodySpec& body, const Box& box) {
  Divisions divisions;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d)
    divisions.along[d] =
        divide(box.lower[d], box.upper[d], wanted_size(grid, body), grid.cell_size);
  return divisions;
}

/// Adds a line of the cells of a level if it leaves at least so much of the box on either side.
void add_line(
    const Box& box, std::size_t axis, double line, double least, std::vector<double>& cuts
) {
  if (line > box.lower[axis] + least && line < box.upper[axis] - least) cuts.push_back(line);
}

/// Lines of the cells of every level next to the ends of a box, so that no particle straddles one.
void add_lines_at_ends(
    const GridSpec& grid,
    const BodySpec& body,
    const Box& box,
    std::size_t axis,
    std::vector<double>& cuts
) {
  for (int level = 0; level <= finest_level(grid); ++level) {
    const double cell = grid.cell_size / (1 << level);
    const double least = least_part_at_cells * cell / body.particles_per_cell;
    const double first = std::floor((box.lower[axis] + least - grid.lower[axis]) / cell) + 1.0;
    const double last = std::ceil((box.upper[axis] - least - grid.lower[axis]) / cell) - 1.0;
    for (const double line : {first, last})
      add_line(box, axis, grid.lower[axis] + line * cell, least, cuts);
  }
}

/// Where a box is cut so that its particles do not straddle tiles of different cells: there the
/// forces of a body in equilibrium would not balance exactly. No cut leaves less than half a
/// particle, unless faces must lie within cells.
std::vector<double> cuts_along(
    const GridSpec& grid, const BodySpec& body, const Box& box, std::size_t axis, BoxCuts where
) {
  std::vector<double> cuts;
  if (!grid.level_of_tile.empty()) {
    const double tile = tile_size_of(grid), least = 0.5 * wanted_size(grid, body);
    const double first = std::floor((box.lower[axis] - grid.lower[axis]) / tile);
    for (double i = first + 1.0; grid.lower[axis] + i * tile < box.upper[axis] - least; ++i)
      add_line(box, axis, grid.lower[axis] + i * tile, least, cuts);
    if (where == BoxCuts::at_cells) add_lines_at_ends(grid, body, box, axis, cuts);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  }
  cuts.insert(cuts.begin(), box.lower[axis]);
  cuts.push_back(box.upper[axis]);
  return cuts;
}

}  // namespace

void for_each_box_part(
    const GridSpec& grid,
    const BodySpec& body,
    const Box& box,
    BoxCuts where,
    const VisitPart& visit
) {
  const auto dimension = static_cast<std::size_t>(dimensions(grid.mode));
  std::array<std::vector<double>, 3> cuts;
  for (std::size_t d = 0; d < 3; ++d)
    cuts[d] = d < dimension ? cuts_along(grid, body, box, d, where) : std::vector<double>{0.0, 0.0};
  std::array<std::size_t, 3> i{};
  for (i[2] = 0; i[2] + 1 < cuts[2].size(); ++i[2])
    for (i[1] = 0; i[1] + 1 < cuts[1].size(); ++i[1])
      for (i[0] = 0; i[0] + 1 < cuts[0].size(); ++i[0]) {
        Box part;
        Vector middle{};
        unsigned ends = 0;
        for (std::size_t d = 0; d < dimension; ++d) {
          part.lower[d] = cuts[d][i[d]];
          part.upper[d] = cuts[d][i[d] + 1];
          middle[d] = 0.5 * (part.lower[d] + part.upper[d]);
          if (i[d] == 0) ends |= 1U << (2 * d);
          if (i[d] + 2 == cuts[d].size()) ends |= 1U << (2 * d + 1);
        }
        const GridSpec own = uniform_grid(grid, level_at(grid, middle));
        visit(own, divide_box(own, body, part), ends);
      }
}

}  // namespace barreno
