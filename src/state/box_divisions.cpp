// SPDX-License-Identifier: BSD-3-Clause
#include "state/box_divisions.hpp"

#include "base/numbers.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

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

/// Where a box is cut so that its particles do not straddle tiles of different cells: there the
/// forces of a body in equilibrium would not balance exactly. No cut leaves less than half a
/// particle.
std::vector<double> cuts_along(
    const GridSpec& grid, const BodySpec& body, const Box& box, std::size_t axis
) {
  std::vector<double> cuts{box.lower[axis]};
  if (!grid.level_of_tile.empty()) {
    const double tile = tile_size_of(grid), least = 0.5 * wanted_size(grid, body);
    const double first = std::floor((box.lower[axis] - grid.lower[axis]) / tile);
    for (double i = first + 1.0; grid.lower[axis] + i * tile < box.upper[axis] - least; ++i)
      if (grid.lower[axis] + i * tile > box.lower[axis] + least)
        cuts.push_back(grid.lower[axis] + i * tile);
  }
  cuts.push_back(box.upper[axis]);
  return cuts;
}

}  // namespace

void for_each_box_part(
    const GridSpec& grid, const BodySpec& body, const Box& box, const VisitPart& visit
) {
  const auto dimension = static_cast<std::size_t>(dimensions(grid.mode));
  std::array<std::vector<double>, 3> cuts;
  for (std::size_t d = 0; d < 3; ++d)
    cuts[d] = d < dimension ? cuts_along(grid, body, box, d) : std::vector<double>{0.0, 0.0};
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
