// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/restrict_sums.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/coarse_nodes.hpp"

namespace barreno {
namespace {

/// Of one tile, which takes the sums of the tiles of the next finer level in it, in their order.
struct RestrictSums {
  Patch patch;
  BoxTiles box;
  ArrayView<TileFrame> frame;
  TileDirectory directory;
  ArrayView<unsigned char> from_parent;
  Nodes nodes;

  KOKKOS_INLINE_FUNCTION void add_tile(int tile, const TilePosition& at, double* to) const {
    const double* const from = &nodes.sums(first_sum(patch, tile));
    for (int slot = 0; slot < patch.size; ++slot) {
      if (from_parent(tile * patch.size + slot) == 0) continue;
      const double* const given = from + slot * sum_components;
      for_each_coarse_node(patch, at, slot, [&](int coarse, double weight) {
        for (int i = 0; i < sum_components; ++i)
          to[coarse * sum_components + i] += weight * given[i];
      });
    }
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (nodes.keeps_sums(tile)) return;
    double* const sums = &nodes.sums(first_sum(patch, tile));
    for_each_finer_tile(box, frame(tile).position, [&](const TilePosition& finer) {
      const int other = directory(box.id(finer));
      if (other >= 0) add_tile(other, finer, sums);
    });
  }
};

}  // namespace

void restrict_sums(const Grid& grid, const Nodes& nodes) {
  if (!grid.is_refined()) return;
  const Region region("restrict_sums");
  for (int level = grid.box.levels - 2; level >= 0; --level)
    launch(
        "restrict_sums",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        RestrictSums{grid.patch, grid.box, grid.tile_frame, grid.directory, grid.from_parent, nodes}
    );
}

}  // namespace barreno
