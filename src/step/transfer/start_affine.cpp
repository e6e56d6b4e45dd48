// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/start_affine.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/transfer/node_moments.hpp"

namespace barreno {
namespace {

template <class M, class S>
struct StartAffine {
  static constexpr int dimensions = M::dimensions;
  PatchFrame<M::dimensions> frame;
  Particles particles;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const double per_cell = frame.first(tile).per_cell;
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch) {
      const BatchRows rows(particles.order, k, end);
      SupportBatch<typename S::template Support<M>> supports;
      find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
      for (int i = 0; i < rows.count; ++i) start_row(rows.row[i], supports.get(i), per_cell);
    }
  }

  template <class Support>
  KOKKOS_INLINE_FUNCTION void start_row(int p, const Support& support, double per_cell) const {
    const NodeMoments<dimensions> moments(frame.patch, support);
    const double square = 1.0 / (per_cell * per_cell);
    for (int i = 0; i < dimensions; ++i) {
      double row[extent<dimensions>] = {};
      for (int d = 0; d < dimensions; ++d)
        for (int e = 0; e < dimensions; ++e)
          row[d] += square * particles.affine(p, dimensions * i + e) * moments.second[e][d];
      for (int d = 0; d < dimensions; ++d) particles.affine(p, dimensions * i + d) = row[d];
    }
  }
};

}  // namespace

void start_affine(const Grid& grid, std::vector<Particles>& sets) {
  const Region region("start_affine");
  visit_kernels(grid, [&](auto mode, auto shape) {
    using Kernel = StartAffine<decltype(mode), decltype(shape)>;
    const PatchFrame<decltype(mode)::dimensions> frame(grid);
    for (Particles& particles : sets)
      if (has_affine_velocity(particles))
        launch("start_affine", range(grid.active), Kernel{frame, particles});
  });
}

}  // namespace barreno
