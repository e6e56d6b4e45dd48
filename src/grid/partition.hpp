// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

#include <vector>

namespace barreno {

/// Tiles to ranks by recursive coordinate bisection of the tiles' weights: cut across the longest
/// side of those that weigh something, where the halves come nearest to the share of their ranks. A
/// cut may go through a slice: a part misses its share by half a tile at most. A pure function of
/// its arguments, so that every rank finds the same owners without communication; tiles without
/// weight go with their surroundings. Of more ranks than tiles some get none.
///
/// @param tiles    tiles of the box along x, y and z
/// @param weights  cost of every tile of the box, z by z, row by row
/// @return rank of every tile
std::vector<int> bisect_tiles(const int (&tiles)[3], const std::vector<double>& weights, int ranks);

}  // namespace barreno
