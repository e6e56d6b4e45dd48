// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/kinematics.hpp"
#include "shape/particle_geometry.hpp"

namespace barreno {

/// What shape functions read of the particles.
struct ShapeFields {
  const FieldView& position;
  const FieldView& half_size;
  const FieldView& deformation;
  const FieldView& rotation;  ///< three dimensions only
};

/// So many cells beyond a symmetry plane is the end of the grid: as far as any support reaches
/// there are nodes, whose values mirror_nodes knows.
inline constexpr double no_end = 1024.0;

/// Turns particles into their geometry in the patch of a tile; captured by value in kernels.
template <unsigned D>
struct PatchFrame {
  static constexpr int dimensions = D;
  Patch patch;
  ArrayView<TileFrame> tile_frame;
  double lower[D];
  double box_cell_size;              ///< that `cells` counts
  double cells[D];                   ///< of the box
  double first_end[D], past_box[D];  ///< no_end beyond symmetry planes, else none
  double largest;
  double widest_half;  ///< of particles that came from larger cells; no limit where all are alike
                       ///< [cells]

  explicit PatchFrame(const Grid& grid)
      : patch(grid.patch),
        tile_frame(grid.tile_frame),
        box_cell_size(grid.cell_size),
        largest(grid.largest_domain),
        widest_half(grid.is_refined() ? 0.5 : no_end) {
    for (int d = 0; d < dimensions; ++d) {
      lower[d] = grid.lower[d];
      cells[d] = grid.cells[d];
      first_end[d] = grid.mirrored[2 * d] ? -no_end : 0.0;
      past_box[d] = grid.mirrored[2 * d + 1] ? no_end : 0.0;
    }
  }

  /// Where the patch of a tile begins on the lattice of the tile's own cells.
  struct First {
    double node[D];          ///< its first node, from the box's lower corner
    double per_cell;         ///< 1 / the tile's cell size
    double low[D], high[D];  ///< ParticleGeometry::low and high
    double widest;           ///< half size of a particle here, at most [length]
  };
  KOKKOS_INLINE_FUNCTION First first(int tile) const {
    const TileFrame& frame = tile_frame(tile);
    double node[D];
    for (int d = 0; d < dimensions; ++d)
      node[d] = frame.position[d] * patch.tile_cells - patch.reach;
    return first(node, frame.cell_size);
  }
  /// Of a patch that would begin at the box's lower corner: for what depends on the size of the
  /// cells and on the radius, but not on the tile.
  KOKKOS_INLINE_FUNCTION First at_corner(double cell_size) const {
    const double node[D] = {};
    return first(node, cell_size);
  }
  KOKKOS_INLINE_FUNCTION First first(const double (&node)[D], double cell_size) const {
    First out;
    out.per_cell = 1.0 / cell_size;
    out.widest = widest_half * cell_size;
    const double own_cells = box_cell_size / cell_size;  // along a cell of the box
    for (int d = 0; d < dimensions; ++d) {
      out.node[d] = node[d];
      out.low[d] = first_end[d] - node[d];
      out.high[d] = cells[d] * own_cells + past_box[d] - node[d];
    }
    return out;
  }

  /// The geometry of row p for shape function S.
  /// @param fields  ShapeFields, or ShapeColumns with p in the batch
  template <class S, class Fields>
  KOKKOS_FORCEINLINE_FUNCTION ParticleGeometry
  geometry(const First& first, const Fields& fields, int p) const {
    ParticleGeometry out;
    for (int d = 0; d < dimensions; ++d) {
      out.x[d] = (fields.position(p, d) - lower[d]) * first.per_cell - first.node[d];
      const double half_size = fields.half_size(p, d);
      out.half[d] = (half_size < first.widest ? half_size : first.widest) * first.per_cell;
      out.low[d] = first.low[d];
      out.high[d] = first.high[d];
    }
    out.axis = lower[0] * first.per_cell + first.node[0];
    out.per_cell = first.per_cell;
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
  template <class Columns>
  KOKKOS_FORCEINLINE_FUNCTION static void find_stretches(
      const Columns& rotation, int p, ParticleGeometry& particle
  ) {
    const auto& f = particle.f;
    if constexpr (dimensions == 3) {
      const SpaceTensor r =
          matrix(SpaceRotation{rotation(p, 0), rotation(p, 1), rotation(p, 2), rotation(p, 3)});
      particle.stretch[0] = r.xx * f[0][0] + r.yx * f[1][0] + r.zx * f[2][0];
      particle.stretch[1] = r.xy * f[0][1] + r.yy * f[1][1] + r.zy * f[2][1];
      particle.stretch[2] = r.xz * f[0][2] + r.yz * f[1][2] + r.zz * f[2][2];
    } else {
      const PlaneRotation r = polar_rotation(PlaneTensor{f[0][0], f[0][1], f[1][0], f[1][1], 1.0});
      particle.stretch[0] = r.c * f[0][0] + r.s * f[1][0];
      particle.stretch[1] = r.c * f[1][1] - r.s * f[0][1];
    }
  }
};

}  // namespace barreno
