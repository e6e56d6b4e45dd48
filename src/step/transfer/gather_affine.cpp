// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/gather_affine.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/transfer/node_moments.hpp"

namespace barreno {
namespace {

template <class M, class S>
struct GatherAffine {
  static constexpr int dimensions = M::dimensions;
  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> motion;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, ReproducibleSum& remembered) const {
    double energy = 0.0;
    const double per_cell = frame.first(tile).per_cell;
    const double* const patch = &motion(first_motion(frame.patch, tile));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch) {
      const BatchRows rows(particles.order, k, end);
      SupportBatch<typename S::template Support<M>> supports;
      find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
      for (int i = 0; i < rows.count; ++i)
        energy += gather_row(rows.row[i], supports.get(i), per_cell, patch);
    }
    remembered += energy;
  }

  /// @return the energy that the row remembers
  template <class Support>
  KOKKOS_INLINE_FUNCTION double gather_row(
      int p, const Support& support, double per_cell, const double* patch
  ) const {
    const NodeMoments<dimensions> moments(frame.patch, support);
    double first[extent<dimensions>][extent<dimensions>] = {};
    support.for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
      double at[extent<dimensions>];
      position_of_slot(frame.patch, slot, at);
      const double* const v = patch + slot * motion_components(dimensions);
      for (int i = 0; i < dimensions; ++i)
        for (int d = 0; d < dimensions; ++d) first[i][d] += s * v[i] * (at[d] - moments.centre[d]);
    });
    const InverseMoments<dimensions> inverse(moments.second);
    double square = 0.0;
    for (int i = 0; i < dimensions; ++i) {
      double slope[extent<dimensions>];
      inverse.solve(first[i], slope);
      for (int d = 0; d < dimensions; ++d) {
        particles.affine(p, dimensions * i + d) = first[i][d] / per_cell;
        square += first[i][d] * slope[d];
      }
    }
    return 0.5 * particles.mass(p) * square;
  }
};

}  // namespace

ReproducibleSum gather_affine(
    const Grid& grid, const std::vector<Nodes>& fields, std::vector<Particles>& sets
) {
  const Region region("gather_affine");
  ReproducibleSum remembered;
  visit_kernels(grid, [&](auto mode, auto shape) {
    using Kernel = GatherAffine<decltype(mode), decltype(shape)>;
    const PatchFrame<decltype(mode)::dimensions> frame(grid);
    for (Particles& particles : sets) {
      if (!has_affine_velocity(particles)) continue;
      const Nodes& nodes = fields[static_cast<std::size_t>(particles.field)];
      ReproducibleSum of_set;
      launch_reduction(
          "gather_affine",
          range(grid.active),
          Kernel{frame, particles, nodes.motion},
          TallyReducer<ReproducibleSum>(of_set)
      );
      remembered += of_set;
    }
  });
  return remembered;
}

}  // namespace barreno
