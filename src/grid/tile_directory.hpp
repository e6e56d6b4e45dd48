// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <cstddef>
#include <vector>

namespace barreno {

/// Where a rank finds the tiles that it stores: number of a tile in the box (BoxTiles) -> local
/// tile, or -1. A table of pages, of which only those with local tiles have entries of their own:
/// of the rest of the box it keeps one number for 256 tiles.
struct TileDirectory {
  static constexpr int bits = 8;
  static constexpr int page_size = 1 << bits;
  ArrayView<int> begin;  ///< of every page: its first entry; 0, that of a page without tiles
  ArrayView<int> entry;
  ArrayView<int> used;  ///< pages with local tiles

  KOKKOS_INLINE_FUNCTION static int page(int tile) { return tile >> bits; }
  KOKKOS_INLINE_FUNCTION static int in_page(int tile) { return tile & (page_size - 1); }
  KOKKOS_INLINE_FUNCTION int operator()(int tile) const {
    return entry(begin(page(tile)) + in_page(tile));
  }
};

/// A directory of so many places in the box, and of no local tile.
TileDirectory make_tile_directory(int places);

/// From now on the directory knows these tiles, by number in the order of the local ones, and no
/// other. Each stands once.
void list_tiles(const std::vector<int>& tiles, TileDirectory& directory);

}  // namespace barreno
