// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/count_rows.hpp"

#include "base/launch.hpp"

namespace barreno {

void count_rows(const Grid& grid, const std::vector<Particles>& sets, const ArrayView<int>& rows) {
  launch(
      "clear_rows", range(grid.active), KOKKOS_LAMBDA(const int tile) { rows(tile) = 0; }
  );
  for (const Particles& particles : sets) {
    const ArrayView<int> tile_begin = particles.tile_begin;
    launch(
        "count_rows",
        range(grid.active),
        KOKKOS_LAMBDA(const int tile) { rows(tile) += tile_begin(tile + 1) - tile_begin(tile); }
    );
  }
}

}  // namespace barreno
