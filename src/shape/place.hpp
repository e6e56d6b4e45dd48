// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/gimp.hpp"

namespace barreno {

/// Turns positions into places in the patch of a tile; captured by value in kernels.
struct PatchFrame {
  double lower_x, lower_y, per_cell;

  explicit PatchFrame(const Grid& grid)
      : lower_x(grid.lower[0]), lower_y(grid.lower[1]), per_cell(1.0 / grid.cell_size) {}

  KOKKOS_INLINE_FUNCTION ParticlePlace
  place(int tile_x, int tile_y, double x, double y, double half_x, double half_y) const {
    const double first_x = tile_x * tile_cells - reach;
    const double first_y = tile_y * tile_cells - reach;
    return {
        (x - lower_x) * per_cell - first_x,
        (y - lower_y) * per_cell - first_y,
        half_x * per_cell,
        half_y * per_cell,
        lower_x * per_cell + first_x,
        per_cell};
  }
};

}  // namespace barreno
