// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

#include <cstddef>

namespace barreno {

/// Sizes of a tile and of its patch: the tile's own nodes and the ones that its particles can reach
/// around it. Slots of a patch run along x, then y, then z.
struct Patch {
  int dimensions = 2;
  int tile_cells = 0;  ///< per direction (scene/tile_size.hpp)
  int tile_bits = 0;   ///< tile_cells = 2^tile_bits
  int reach = 1;       ///< nodes beyond the tile's own cells
  int nodes = 0;       ///< per direction
  int size = 0;        ///< nodes of the patch
  int cells = 0;       ///< of the tile
  int near = 0;        ///< tiles on either side, per direction, whose patches overlap this one
  int neighbours = 0;  ///< the tile and those near it, lexicographic

  /// Tiles on either side along one axis; none where the box has no such axis.
  KOKKOS_INLINE_FUNCTION int near_along(int axis) const { return axis < dimensions ? near : 0; }
  KOKKOS_INLINE_FUNCTION int nodes_along(int axis) const { return axis < dimensions ? nodes : 1; }

  /// First slot along an axis that a tile `offset` tiles away shares, and one past the last.
  KOKKOS_INLINE_FUNCTION int overlap_begin(int offset) const {
    return offset > 0 ? offset * tile_cells : 0;
  }
  KOKKOS_INLINE_FUNCTION int overlap_end(int offset) const {
    return offset < 0 ? nodes + offset * tile_cells : nodes;
  }
};

/// Place of a slot in its patch along each of N axes.
template <class T, std::size_t N>
KOKKOS_INLINE_FUNCTION void position_of_slot(const Patch& patch, int slot, T (&at)[N]) {
  for (std::size_t d = 0; d < N; ++d, slot /= patch.nodes) at[d] = slot % patch.nodes;
}

/// Nodes per direction of the largest patch: kernels keep one row of nodes on their stack.
inline constexpr int max_patch_nodes = 64;

/// The patch for particles that reach `reach` nodes beyond the cells of their tile.
///
/// @throws std::logic_error if a row of its nodes is longer than max_patch_nodes
Patch make_patch(int dimensions, int reach);

/// visit(number of the neighbour, its offset in tiles along x, y, z), lexicographic.
template <class Visitor>
KOKKOS_INLINE_FUNCTION void for_each_neighbour(const Patch& patch, Visitor&& visit) {
  int k = 0;
  for (int z = -patch.near_along(2); z <= patch.near_along(2); ++z)
    for (int y = -patch.near_along(1); y <= patch.near_along(1); ++y)
      for (int x = -patch.near; x <= patch.near; ++x) visit(k++, x, y, z);
}

/// visit(slot) for the nodes of a patch that the one so many tiles away along x, y, z holds too.
template <class Visitor>
KOKKOS_INLINE_FUNCTION void for_each_shared_slot(
    const Patch& patch, const int (&offset)[3], const Visitor& visit
) {
  int begin[3] = {0, 0, 0}, end[3] = {1, 1, 1};
  for (int d = 0; d < patch.dimensions; ++d) {
    begin[d] = patch.overlap_begin(offset[d]);
    end[d] = patch.overlap_end(offset[d]);
  }
  for (int z = begin[2]; z < end[2]; ++z)
    for (int y = begin[1]; y < end[1]; ++y)
      for (int x = begin[0]; x < end[0]; ++x) visit((z * patch.nodes + y) * patch.nodes + x);
}

}  // namespace barreno
