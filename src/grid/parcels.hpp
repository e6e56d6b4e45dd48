// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <cstddef>

namespace barreno {

/// Parcels of a box: tiles of level 0 that always have the same owner, 2^bits along each axis. A
/// parcel is one tile, unless the box has more tiles than every rank can know owners and costs of:
/// what all ranks keep of the whole box does not grow without end with it.
struct Parcels {
  int bits = 0;
  int tiles[3] = {0, 0, 1};  ///< of level 0 along x, y and z
  int along[3] = {0, 0, 1};  ///< parcels; those at the upper ends may be smaller

  Parcels() = default;
  /// The smallest parcels of which there are at most `most`.
  Parcels(int dimensions, const int (&of_box)[3], std::size_t most)
      : tiles{of_box[0], of_box[1], of_box[2]}, along{of_box[0], of_box[1], of_box[2]} {
    while (count() > most) {
      ++bits;
      for (int d = 0; d < dimensions; ++d) along[d] = ((tiles[d] - 1) >> bits) + 1;
    }
  }

  std::size_t count() const {
    std::size_t parcels = 1;
    for (const int n : along) parcels *= static_cast<std::size_t>(n);
    return parcels;
  }
  /// The parcel of a tile of level 0, both by number, x fastest.
  KOKKOS_INLINE_FUNCTION int holding(int tile) const {
    if (bits == 0) return tile;
    const int x = tile % tiles[0], row = tile / tiles[0];
    const int y = row % tiles[1], z = row / tiles[1];
    return ((z >> bits) * along[1] + (y >> bits)) * along[0] + (x >> bits);
  }
};

/// Ranks of tiles of level 0, for kernels.
struct TileOwners {
  Parcels parcels;
  ArrayView<int> rank;  ///< of every parcel

  KOKKOS_INLINE_FUNCTION int operator()(int tile) const { return rank(parcels.holding(tile)); }
};

}  // namespace barreno
