// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// A tile has 2^tile_bits cells in each direction. Smaller ones would work on more copies of nodes:
/// of 4 x 4 x 4 cells a patch has 5 to 11 nodes for each of its cells, of 8 x 8 x 8 3 to 4.
constexpr int tile_bits = 3;
constexpr int tile_cells = 1 << tile_bits;
/// They may be half as large, so that a narrow region is refined alone.
constexpr int small_tile_bits = 2;

}  // namespace barreno
