// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/subcycling.hpp"

#include <vector>

namespace barreno {

/// How many times a particle's path leads into a tile that is not active yet, in cells as large as
/// its own or larger: into smaller ones it comes early in any case (find_early_arrivals).
int count_reached_tiles(const Grid& grid, const Subcycling& subcycling);

/// Those tiles by number, ascending, whichever rank they belong to.
std::vector<int> reached_tiles(const Grid& grid, const Subcycling& subcycling);

}  // namespace barreno
