// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"

namespace barreno {

/// List the rows of a set by (tile, cell, id) in Particles::order and where each tile's begin in
/// tile_begin, however the rows are stored: a counting sort by cell, then by id within a cell.
///
/// @pre  all rows are placed (locate_particles)
/// @post particles.sorted
void sort_by_cell(const Grid& grid, Particles& particles);

}  // namespace barreno
