// SPDX-License-Identifier: BSD-3-Clause
#include "step/interpolate_motion.hpp"

#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/place.hpp"
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

using Motion = Pack<motion_components>;

template <class M, class S>
struct InterpolateMotion {
  PatchFrame frame;
  ArrayView<int> tile_x, tile_y;
  Particles particles;
  ArrayView<double> motion;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, double& largest) const {
    const Motion* const patch = as_packs<motion_components>(
        &motion(static_cast<std::size_t>(tile) * patch_size * motion_components)
    );
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; ++k) {
      const int p = particles.order(k);
      const auto support = S::template support<M>(frame.place(
          tile_x(tile),
          tile_y(tile),
          particles.position(p, 0),
          particles.position(p, 1),
          particles.half_size(p, 0),
          particles.half_size(p, 1)
      ));
      Motion v{}, dx{}, dy{}, hoop{};
      support.for_each_node([&](int slot, double s, double gx, double gy, double t) {
        const Motion node = patch[slot];
        v += s * node;
        dx += gx * node;
        dy += gy * node;
        if constexpr (M::hoop) hoop += t * node;
      });
      for (int i = 0; i < motion_components; ++i) particles.grid_motion(p, i) = v[i];
      particles.increment(p, 0) = dt * dx[0];
      particles.increment(p, 1) = dt * dy[0];
      particles.increment(p, 2) = dt * dx[1];
      particles.increment(p, 3) = dt * dy[1];
      particles.increment(p, 4) = dt * hoop[0];
      largest = std::fmax(largest, dt * dt * strain_squared(dx[0], dy[0], dx[1], dy[1], hoop[0]));
    }
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
        Kernel{PatchFrame(grid), grid.tile_x, grid.tile_y, particles, nodes.motion, dt},
        Kokkos::Max<double>(largest)
    );
  });
  return std::sqrt(std::fmax(largest, 0.0));
}

}  // namespace barreno
