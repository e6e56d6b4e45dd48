// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/bodies/body_particles.hpp"

#include <array>
#include <functional>

namespace barreno {

/// Even division of an interval into particles of about the wanted size, none wider than a cell.
struct Division {
  double lower = 0.0, size = 0.0;
  long long count = 1;
  double centre(long long i) const { return lower + (static_cast<double>(i) + 0.5) * size; }
};
Division divide(double lower, double upper, double wanted, double cell_size);

/// Particles of a box or a slug: one division per axis.
struct Divisions {
  Division along[3];
};
using PlaceIndex = std::array<long long, 3>;

long long count_places(const Divisions& divisions);
/// The particle of a place, without an id.
NewParticle particle_at(const GridSpec& grid, const Divisions& divisions, const PlaceIndex& index);

/// Edge of a body's particles where nothing is refined [length].
double wanted_size(const GridSpec& grid, const BodySpec& body);

/// visit(grid with the cells of a part's level everywhere, divisions of the part, bits by Face of
/// the sides at which it ends the box) for the parts of a box between the borders of tiles of
/// different cells, in the order of ids; where nothing is refined there is one.
using VisitPart = std::function<void(const GridSpec&, const Divisions&, unsigned)>;
void for_each_box_part(
    const GridSpec& grid,
    const BodySpec& body,
    const Box& box,
    BoxCuts where,
    const VisitPart& visit
);

}  // namespace barreno
