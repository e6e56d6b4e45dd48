// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/particle_place.hpp"

namespace barreno {

/// Turns positions into places in the patch of a tile; captured by value in kernels.
template <unsigned D>
struct PatchFrame {
  static constexpr int dimensions = D;
  Patch patch;
  ArrayView<TilePlace> tile_place;
  double lower[D];
  double cells[D];
  double per_cell;
  double largest;

  PatchFrame(const Scene& scene, const Grid& grid)
      : patch(grid.patch),
        tile_place(grid.tile_place),
        per_cell(1.0 / grid.cell_size),
        largest(scene.step.largest_domain) {
    for (int d = 0; d < dimensions; ++d) {
      lower[d] = grid.lower[d];
      cells[d] = grid.cells[d];
    }
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

  /// The place of row p for shape function S.
  template <class S>
  KOKKOS_INLINE_FUNCTION ParticlePlace place(
      const First& first,
      const FieldView& position,
      const FieldView& half_size,
      const FieldView& deformation,
      int p
  ) const {
    ParticlePlace out;
    for (int d = 0; d < dimensions; ++d) {
      out.x[d] = (position(p, d) - lower[d]) * per_cell - first.node[d];
      out.half[d] = half_size(p, d) * per_cell;
      out.low[d] = -first.node[d];
      out.high[d] = cells[d] - first.node[d];
    }
    out.axis = lower[0] * per_cell + first.node[0];
    out.per_cell = per_cell;
    out.row = patch.nodes;
    out.last = patch.nodes - 1;
    out.largest = largest;
    if constexpr (S::follows_deformation)
      for (int i = 0; i < dimensions; ++i)
        for (int k = 0; k < dimensions; ++k) out.f[i][k] = deformation(p, dimensions * i + k);
    return out;
  }
};

}  // namespace barreno
