// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// A tile has 2^tile_bits cells in each direction: 8 in the plane, 4 in space, where a patch of 8
/// would not fit into the first-level cache.
constexpr int tile_bits(int dimensions) {
  return dimensions == 3 ? 2 : 3;
}
constexpr int tile_cells(int dimensions) {
  return 1 << tile_bits(dimensions);
}
/// In the plane they may be half as large, so that a narrow region is refined alone.
constexpr int small_tile_bits = 2;

}  // namespace barreno
