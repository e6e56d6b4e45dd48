// SPDX-License-Identifier: BSD-3-Clause
#include "step/interpolate_motion.hpp"

#include "base/launch.hpp"
#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"

namespace barreno {
namespace {

/// Without the call that fmax costs.
KOKKOS_INLINE_FUNCTION double larger(double a, double b) {
  return b > a ? b : a;
}

template <class M, class S>
struct InterpolateMotion {
  static constexpr int dimensions = M::dimensions;
  static constexpr int components = motion_components(dimensions);
  using Motion = Pack<components>;

  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> motion;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, double& largest) const {
    const Motion* const patch = as_packs<components>(&motion(first_motion(frame.patch, tile)));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
      largest = larger(largest, batch(tile, BatchRows(particles.order, k, end), patch));
  }

  /// Square of the Frobenius norm of D, the symmetric part of L; d[j][i] = dv_i / dx_j.
  KOKKOS_INLINE_FUNCTION static double rate_squared(const Motion* d, double hoop) {
    double sum = hoop * hoop;
    for (int i = 0; i < dimensions; ++i) {
      sum += d[i][i] * d[i][i];
      for (int j = 0; j < i; ++j) {
        const double shear = d[j][i] + d[i][j];
        sum += 0.5 * shear * shear;
      }
    }
    return sum;
  }

  KOKKOS_INLINE_FUNCTION double batch(int tile, const BatchRows& rows, const Motion* patch) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
    const FieldView grid_motion = particles.grid_motion.values;
    const FieldView increment = particles.increment.values;
    double largest = 0.0;
    for (int k = 0; k < rows.count; ++k) {
      const int p = rows.row[k];
      const auto at = supports.get(k).template interpolate<M::hoop>(patch, frame.patch);
      for (int i = 0; i < 2 * dimensions; ++i) grid_motion(p, i) = at.value[i];
      for (int i = 0; i < dimensions; ++i)
        for (int j = 0; j < dimensions; ++j) increment(p, dimensions * i + j) = dt * at.d[j][i];
      if constexpr (dimensions == 2) increment(p, 4) = dt * at.hoop[0];
      largest = larger(largest, dt * dt * rate_squared(at.d, at.hoop[0]));
    }
    return largest;
  }
};

}  // namespace

double interpolate_motion(
    const Scene& scene, const Grid& grid, const Nodes& nodes, double dt, Particles& particles
) {
  const Region region("interpolate_motion");
  double largest = 0.0;
  visit_kernels(scene, [&](auto mode, auto shape) {
    using Kernel = InterpolateMotion<decltype(mode), decltype(shape)>;
    launch_reduction(
        "interpolate_motion",
        range(grid.active),
        Kernel{PatchFrame<decltype(mode)::dimensions>(scene, grid), particles, nodes.motion, dt},
        Kokkos::Max<double>(largest)
    );
  });
  return std::sqrt(larger(largest, 0.0));
}

}  // namespace barreno
