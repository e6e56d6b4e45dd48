// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/gimp.hpp"

namespace barreno {

/// Turns positions into places in the patch of a tile; captured by value in kernels.
template <unsigned D>
struct PatchFrame {
  static constexpr int dimensions = D;
  Patch patch;
  ArrayView<TilePlace> tile_place;
  double lower[D];
  double per_cell;

  explicit PatchFrame(const Grid& grid)
      : patch(grid.patch), tile_place(grid.tile_place), per_cell(1.0 / grid.cell_size) {
    for (int d = 0; d < dimensions; ++d) lower[d] = grid.lower[d];
  }

  /// Node of the box that is the first of a tile's patch, along each axis.
  struct First {
    double node[D];
  };
  KOKKOS_INLINE_FUNCTION First first(int tile) const {
    First out;
    for (int d = 0; d < dimensions; ++d)
      out.node[d] = tile_place(tile)[d] * patch.tile_cells - patch.reach;
    return out;
  }

  KOKKOS_INLINE_FUNCTION ParticlePlace
  place(const First& first, const FieldView& position, const FieldView& half_size, int p) const {
    ParticlePlace out;
    for (int d = 0; d < dimensions; ++d) {
      out.x[d] = (position(p, d) - lower[d]) * per_cell - first.node[d];
      out.half[d] = half_size(p, d) * per_cell;
    }
    out.axis = lower[0] * per_cell + first.node[0];
    out.per_cell = per_cell;
    out.row = patch.nodes;
    return out;
  }
};

}  // namespace barreno
