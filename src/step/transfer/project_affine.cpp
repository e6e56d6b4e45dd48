// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/project_affine.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/transfer/node_moments.hpp"

namespace barreno {
namespace {

template <class M, class S>
struct ProjectAffine {
  static constexpr int dimensions = M::dimensions;
  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> sums;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    double* const patch = &sums(first_sum(frame.patch, tile));
    const double per_cell = frame.first(tile).per_cell;
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch) {
      const BatchRows rows(particles.order, k, end);
      SupportBatch<typename S::template Support<M>> supports;
      find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
      for (int i = 0; i < rows.count; ++i) add_row(rows.row[i], supports.get(i), per_cell, patch);
    }
  }

  template <class Support>
  KOKKOS_INLINE_FUNCTION void add_row(int p, const Support& support, double per_cell, double* patch)
      const {
    const NodeMoments<dimensions> moments(frame.patch, support);
    const InverseMoments<dimensions> inverse(moments.second);
    double slope[extent<dimensions>][extent<dimensions>];  // of the momentum [per cell]
    for (int i = 0; i < dimensions; ++i) {
      double first[extent<dimensions>];
      const double scale = particles.mass(p) * per_cell;
      for (int d = 0; d < dimensions; ++d)
        first[d] = scale * particles.affine(p, dimensions * i + d);
      inverse.solve(first, slope[i]);
    }
    support.for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
      double at[extent<dimensions>];
      position_of_slot(frame.patch, slot, at);
      double* const momentum = patch + slot * sum_components + 1;
      for (int i = 0; i < dimensions; ++i)
        for (int d = 0; d < dimensions; ++d)
          momentum[i] += s * slope[i][d] * (at[d] - moments.centre[d]);
    });
  }
};

}  // namespace

void project_affine(const Grid& grid, const Particles& particles, Nodes& nodes) {
  if (!has_affine_velocity(particles)) return;
  const Region region("project_affine");
  visit_kernels(grid, [&](auto mode, auto shape) {
    using Kernel = ProjectAffine<decltype(mode), decltype(shape)>;
    launch(
        "project_affine",
        range(grid.active),
        Kernel{PatchFrame<decltype(mode)::dimensions>(grid), particles, nodes.sums}
    );
  });
}

}  // namespace barreno
