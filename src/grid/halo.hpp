// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

#include <vector>

namespace barreno {

/// Build the exchange plan for the active tiles of all ranks and find the ghosts: tiles of other
/// ranks whose patch overlaps one of ours. Collective.
///
/// @param owned  box ids of this rank's active tiles, ascending
/// @return box ids of the ghosts, in the order in which exchange_halo stores them
std::vector<int> build_halo(Grid& grid, const std::vector<int>& owned);

/// Fetch the partial sums of the ghost tiles: afterwards rows [active, active + ghosts) of `sums`
/// are the owners' own. One message per neighbour. Collective; nothing to do on one rank.
///
/// @param[in,out] sums  (local tile, slot, component), `width` doubles per tile
void exchange_halo(const Grid& grid, const ArrayView<double>& sums, int width);

}  // namespace barreno
