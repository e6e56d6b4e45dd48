// SPDX-License-Identifier: BSD-3-Clause
#include "step/project_particles.hpp"

#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "shape/place.hpp"
#include "shape/visit_kernels.hpp"

namespace barreno {
namespace {

using Sums = Pack<sum_components>;

/// What one particle gives to its nodes: sums += S a + dS/dx b + dS/dy c + T d.
struct Contribution {
  Sums a, b, c, d;
};

template <class M>
KOKKOS_INLINE_FUNCTION Contribution contribution(const Particles& particles, int p) {
  const PlaneTensor f = load_plane_tensor<M>(particles.deformation_gradient.values, p);
  const Sym3 unrotated{
      particles.stress(p, 0),
      particles.stress(p, 1),
      particles.stress(p, 2),
      particles.stress(p, 3),
      0.0,
      0.0};
  const Sym3 stress = rotate(polar_rotation(f), unrotated);
  const double q = particles.viscous_pressure(p);
  const double volume = particles.volume(p);
  const double m = particles.mass(p);
  const double pressed_xx = -volume * (stress.xx - q);
  const double pressed_yy = -volume * (stress.yy - q);
  const double shear = -volume * stress.xy;
  const double hoop = M::hoop ? -volume * (stress.zz - q) : 0.0;
  Contribution out;
  out.a = Sums{m, m * particles.velocity(p, 0), m * particles.velocity(p, 1)};
  out.b = Sums{0.0, 0.0, 0.0, pressed_xx, shear};
  out.c = Sums{0.0, 0.0, 0.0, shear, pressed_yy};
  out.d = Sums{0.0, 0.0, 0.0, hoop};
  return out;
}

template <class M, class S>
struct ProjectParticles {
  PatchFrame frame;
  ArrayView<int> tile_x, tile_y;
  Particles particles;
  ArrayView<double> sums;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    Sums* const patch =
        as_packs<sum_components>(&sums(static_cast<std::size_t>(tile) * patch_size * sum_components)
        );
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; ++k) {
      const int p = particles.order(k);
      const Contribution give = contribution<M>(particles, p);
      const auto support = S::template support<M>(frame.place(
          tile_x(tile),
          tile_y(tile),
          particles.position(p, 0),
          particles.position(p, 1),
          particles.half_size(p, 0),
          particles.half_size(p, 1)
      ));
      support.for_each_node([&](int slot, double s, double gx, double gy, double t) {
        Sums sum = patch[slot] + s * give.a + gx * give.b + gy * give.c;
        if constexpr (M::hoop) sum += t * give.d;
        patch[slot] = sum;
      });
    }
  }
};

}  // namespace

void clear_nodes(const Grid& grid, Nodes& nodes) {
  const auto n = static_cast<std::size_t>(grid.active + grid.ghosts) * patch_size;
  if (nodes.sums.extent(0) < n * sum_components)
    nodes.sums = ArrayView<double>(
        Kokkos::ViewAllocateWithoutInitializing("sums"), 5 * n * sum_components / 4
    );
  if (nodes.motion.extent(0) < n * motion_components)
    nodes.motion = ArrayView<double>(
        Kokkos::ViewAllocateWithoutInitializing("motion"), 5 * n * motion_components / 4
    );
  const auto used = static_cast<std::size_t>(grid.active) * patch_size * sum_components;
  Kokkos::deep_copy(Kokkos::subview(nodes.sums, std::make_pair(std::size_t{0}, used)), 0.0);
}

void project_particles(
    const Scene& scene, const Grid& grid, const Particles& particles, Nodes& nodes
) {
  const Region region("project_particles");
  visit_kernels(scene, [&](auto mode, auto shape) {
    using Kernel = ProjectParticles<decltype(mode), decltype(shape)>;
    Kokkos::parallel_for(
        "project_particles",
        range(grid.active),
        Kernel{PatchFrame(grid), grid.tile_x, grid.tile_y, particles, nodes.sums}
    );
  });
}

}  // namespace barreno
