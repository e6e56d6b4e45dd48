// SPDX-License-Identifier: BSD-3-Clause
#include "step/interpolate_motion.hpp"

#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"

namespace barreno {
namespace {

/// Frobenius norm of the symmetric part of dt L, squared.
KOKKOS_INLINE_FUNCTION double strain_squared(
    double xx, double xy, double yx, double yy, double zz
) {
  const double shear = xy + yx;
  return xx * xx + yy * yy + zz * zz + 0.5 * shear * shear;
}

/// Without the call that fmax costs.
KOKKOS_INLINE_FUNCTION double larger(double a, double b) {
  return b > a ? b : a;
}

using Motion = Pack<motion_components>;

template <class M, class S>
struct InterpolateMotion {
  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> motion;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, double& largest) const {
    const Motion* const patch =
        as_packs<motion_components>(&motion(first_motion(frame.patch, tile)));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
      largest = larger(largest, batch(tile, BatchRows(particles.order, k, end), patch));
  }

  KOKKOS_INLINE_FUNCTION double batch(int tile, const BatchRows& rows, const Motion* patch) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(
        frame, tile, rows, particles.position.values, particles.half_size.values, supports
    );
    const FieldView grid_motion = particles.grid_motion.values;
    const FieldView increment = particles.increment.values;
    double largest = 0.0;
    for (int k = 0; k < rows.count; ++k) {
      const int p = rows.row[k];
      const auto at = supports.get(k).template interpolate<M::hoop>(patch, frame.patch);
      for (int i = 0; i < motion_components; ++i) grid_motion(p, i) = at.value[i];
      increment(p, 0) = dt * at.d[0][0];
      increment(p, 1) = dt * at.d[1][0];
      increment(p, 2) = dt * at.d[0][1];
      increment(p, 3) = dt * at.d[1][1];
      increment(p, 4) = dt * at.hoop[0];
      largest = larger(
          largest,
          dt * dt * strain_squared(at.d[0][0], at.d[1][0], at.d[0][1], at.d[1][1], at.hoop[0])
      );
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
    Kokkos::parallel_reduce(
        "interpolate_motion",
        range(grid.active),
        Kernel{PatchFrame<decltype(mode)::dimensions>(grid), particles, nodes.motion, dt},
        Kokkos::Max<double>(largest)
    );
  });
  return std::sqrt(larger(largest, 0.0));
}

}  // namespace barreno
