// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

namespace barreno {

/// Nodes of the next coarser lattice that a node of a refined tile stands for: the one that it
/// coincides with, or the 2, 4 or 8 around it, each with the same weight. So functions that are
/// linear in x are taken over exactly, and sums that are given back with the same weights keep mass
/// and momentum. visit(slot of the coarser tile that holds the refined one, weight)
///
/// @param at  position of the refined tile
template <class Visitor>
KOKKOS_INLINE_FUNCTION void for_each_coarse_node(
    const Patch& patch, const TilePosition& at, int slot, Visitor&& visit
) {
  int place[3];
  position_of_slot(patch, slot, place);
  int first[3] = {}, count[3] = {1, 1, 1};
  double weight = 1.0;
  for (int d = 0; d < patch.dimensions; ++d) {
    const int node = at[d] * patch.tile_cells - patch.reach + place[d];
    first[d] = (node >> 1) - (at[d] >> 1) * patch.tile_cells + patch.reach;
    count[d] = 1 + (node & 1);
    weight /= count[d];
  }
  for (int z = 0; z < count[2]; ++z)
    for (int y = 0; y < count[1]; ++y)
      for (int x = 0; x < count[0]; ++x)
        visit(((first[2] + z) * patch.nodes + first[1] + y) * patch.nodes + first[0] + x, weight);
}

}  // namespace barreno
