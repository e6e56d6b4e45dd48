// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/kinematics.hpp"
#include "shape/particle_place.hpp"

namespace barreno {

/// What shape functions read of the particles.
struct ShapeFields {
  const FieldView& position;
  const FieldView& half_size;
  const FieldView& deformation;
  const FieldView& rotation;  ///< three dimensions only
};

/// So many cells beyond a symmetry plane is the end of the grid: as far as any support reaches
/// there are nodes, whose values mirror_walls knows.
inline constexpr double no_end = 1024.0;

/// Turns positions into places in the patch of a tile; captured by value in kernels.
template <unsigned D>
struct PatchFrame {
  static constexpr int dimensions = D;
  Patch patch;
  ArrayView<TilePlace> tile_place;
  double lower[D];
  double first_end[D], last_end[D];  ///< ParticlePlace::low and high, from the grid's lower corner
  double per_cell;
  double largest;

  PatchFrame(const Scene& scene, const Grid& grid)
      : patch(grid.patch),
        tile_place(grid.tile_place),
        per_cell(1.0 / grid.cell_size),
        largest(scene.step.largest_domain) {
    for (int d = 0; d < dimensions; ++d) {
      lower[d] = grid.lower[d];
      first_end[d] = 0.0;
      last_end[d] = grid.cells[d];
    }
    for (const ConditionSpec& condition : scene.conditions) {
      const int face = static_cast<int>(condition.face);
      if (condition.kind != ConditionKind::symmetry || face / 2 >= dimensions) continue;
      (face % 2 == 0 ? first_end : last_end)[face / 2] += face % 2 == 0 ? -no_end : no_end;
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
  KOKKOS_FORCEINLINE_FUNCTION ParticlePlace
  place(const First& first, const ShapeFields& fields, int p) const {
    ParticlePlace out;
    for (int d = 0; d < dimensions; ++d) {
      out.x[d] = (fields.position(p, d) - lower[d]) * per_cell - first.node[d];
      out.half[d] = fields.half_size(p, d) * per_cell;
      out.low[d] = first_end[d] - first.node[d];
      out.high[d] = last_end[d] - first.node[d];
    }
    out.axis = lower[0] * per_cell + first.node[0];
    out.per_cell = per_cell;
    out.row = patch.nodes;
    out.last = patch.nodes - 1;
    out.largest = largest;
    if constexpr (S::follows_deformation) {
      for (int i = 0; i < dimensions; ++i)
        for (int k = 0; k < dimensions; ++k)
          out.f[i][k] = fields.deformation(p, dimensions * i + k);
      if constexpr (S::form == ParticleForm::box) find_stretches(fields.rotation, p, out);
    }
    return out;
  }

  /// Diagonal of U = R^T F.
  KOKKOS_FORCEINLINE_FUNCTION static void find_stretches(
      const FieldView& rotation, int p, ParticlePlace& place
  ) {
    const auto& f = place.f;
    if constexpr (dimensions == 3) {
      const SpaceTensor r =
          matrix(SpaceRotation{rotation(p, 0), rotation(p, 1), rotation(p, 2), rotation(p, 3)});
      place.stretch[0] = r.xx * f[0][0] + r.yx * f[1][0] + r.zx * f[2][0];
      place.stretch[1] = r.xy * f[0][1] + r.yy * f[1][1] + r.zy * f[2][1];
      place.stretch[2] = r.xz * f[0][2] + r.yz * f[1][2] + r.zz * f[2][2];
    } else {
      const PlaneRotation r = polar_rotation(PlaneTensor{f[0][0], f[0][1], f[1][0], f[1][1], 1.0});
      place.stretch[0] = r.c * f[0][0] + r.s * f[1][0];
      place.stretch[1] = r.c * f[1][1] - r.s * f[0][1];
    }
  }
};

}  // namespace barreno
