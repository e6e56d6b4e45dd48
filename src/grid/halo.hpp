// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

#include <vector>

namespace barreno {

/// Build the exchange plan for the active tiles of all ranks and find the ghosts: tiles of other
/// ranks whose patch overlaps one of ours. Collective.
///
/// @param owned  box ids of this rank's active tiles, ascending
/// @return box ids of the ghosts, in the order in which they are stored
std::vector<int> build_halo(Grid& grid, const std::vector<int>& owned);

/// Fetch the partial sums of the ghosts' nodes: afterwards those that a patch of this rank holds
/// too (Grid::fetched) are the owners' own; the ghosts' other nodes keep what is there. One message
/// per neighbour. Collective; nothing to do on one rank.
///
/// @param[in,out] sums  (local tile, slot, component), `components` doubles per node
void exchange_halo(const Grid& grid, const ArrayView<double>& sums, int components);

/// The same of what whole tiles have, `width` doubles of each.
void exchange_tiles(const Grid& grid, const ArrayView<double>& values, int width);

}  // namespace barreno
