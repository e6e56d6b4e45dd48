// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

namespace barreno {

/// The tiles whose patches hold a node, as a kernel captures them.
struct NodeCopies {
  Patch patch;
  ArrayView<int> neighbours;

  explicit NodeCopies(const Grid& grid) : patch(grid.patch), neighbours(grid.neighbours) {}

  /// Place of a slot in its patch along each axis.
  KOKKOS_INLINE_FUNCTION void position(int slot, int (&at)[3]) const {
    position_of_slot(patch, slot, at);
  }

  /// visit(tile, slot) for every copy of a node of an own tile, its own included, in lexicographic
  /// order of the tiles: sums over them are the same to the last bit wherever they are taken.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each(int tile, int slot, Visitor&& visit) const {
    int at[3];
    position(slot, at);
    for_each_neighbour(patch, [&](int k, int dx, int dy, int dz) {
      const int x = at[0] - dx * patch.tile_cells;
      const int y = at[1] - dy * patch.tile_cells;
      const int z = at[2] - dz * patch.tile_cells;
      if (x < 0 || x >= patch.nodes || y < 0 || y >= patch.nodes || z < 0 ||
          z >= patch.nodes_along(2))
        return;
      const int other = neighbours(tile * patch.neighbours + k);
      if (other >= 0) visit(other, (z * patch.nodes + y) * patch.nodes + x);
    });
  }

  /// Adds all copies of a node's values, so many per node.
  KOKKOS_INLINE_FUNCTION void add(
      const ArrayView<double>& values, int components, int tile, int slot, double* total
  ) const {
    for (int i = 0; i < components; ++i) total[i] = 0.0;
    for_each(tile, slot, [&](int other, int there) {
      const std::size_t first =
          static_cast<std::size_t>(other) * static_cast<std::size_t>(patch.size * components) +
          static_cast<std::size_t>(there * components);
      for (int i = 0; i < components; ++i) total[i] += values(first + static_cast<std::size_t>(i));
    });
  }
};

}  // namespace barreno
