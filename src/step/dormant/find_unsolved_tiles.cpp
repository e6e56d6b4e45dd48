// SPDX-License-Identifier: BSD-3-Clause
#include "step/dormant/find_unsolved_tiles.hpp"

#include "base/launch.hpp"

namespace barreno {

void find_unsolved_tiles(const Grid& grid, const DormantNodes& nodes) {
  if (!nodes.dormancy.on) return;
  const Dormancy dormancy = nodes.dormancy;
  launch(
      "find_unsolved_tiles",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        const bool stays = nodes.stays_motionless(tile);
        dormancy.unsolved(tile) = stays ? 1 : 0;
        if (nodes.subcycling.starts(tile)) dormancy.motionless(tile) = 1;  // so far
      }
  );
  const ArrayView<int> parent = grid.parent;
  for (int level = grid.box.levels - 1; level > 0; --level)
    launch(
        "solve_with_finer_tiles",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        KOKKOS_LAMBDA(const int tile) {
          if (dormancy.unsolved(tile) == 0) dormancy.unsolved(parent(tile)) = 0;
        }
    );
}

}  // namespace barreno
