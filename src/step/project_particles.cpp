// SPDX-License-Identifier: BSD-3-Clause
#include "step/project_particles.hpp"

#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"

namespace barreno {
namespace {

using Sums = Pack<sum_components>;

/// What one particle gives to its nodes: S times mass and momentum, and the resultants of its
/// stress, -V (sigma - q I), times the gradients of S.
enum Give { mass, momentum_x, momentum_y, force_xx, force_xy, force_yy, force_hoop, nothing };

template <class M>
KOKKOS_INLINE_FUNCTION void find_given(
    const Particles& particles, int p, double (&out)[sum_components]
) {
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
  out[mass] = m;
  out[momentum_x] = m * particles.velocity(p, 0);
  out[momentum_y] = m * particles.velocity(p, 1);
  out[force_xx] = -volume * (stress.xx - q);
  out[force_xy] = -volume * stress.xy;
  out[force_yy] = -volume * (stress.yy - q);
  out[force_hoop] = M::hoop ? -volume * (stress.zz - q) : 0.0;
  out[nothing] = 0.0;
}

template <class M, class S>
struct ProjectParticles {
  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> sums;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    Sums* const patch = as_packs<sum_components>(&sums(first_sum(frame.patch, tile)));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
      batch(tile, BatchRows(particles.order, k, end), patch);
  }

  KOKKOS_INLINE_FUNCTION void batch(int tile, const BatchRows& rows, Sums* patch) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(
        frame, tile, rows, particles.position.values, particles.half_size.values, supports
    );
    alignas(sizeof(Sums)) double given[rows_per_batch][sum_components];
    BARRENO_IVDEP
    for (int k = 0; k < rows_per_batch; ++k) find_given<M>(particles, rows.row[k], given[k]);
    for (int k = 0; k < rows.count; ++k) {
      constexpr int o = nothing;
      const Sums& g = *as_packs<sum_components>(given[k]);
      supports.get(k).template add_to<M::hoop>(
          patch,
          frame.patch,
          select<mass, momentum_x, momentum_y, o, o, o, o, o>(g),
          {select<o, o, o, force_xx, force_xy, o, o, o>(g),
           select<o, o, o, force_xy, force_yy, o, o, o>(g)},
          select<o, o, o, force_hoop, o, o, o, o>(g)
      );
    }
  }
};

}  // namespace

void clear_nodes(const Grid& grid, Nodes& nodes) {
  const auto n = static_cast<std::size_t>(grid.active + grid.ghosts) *
                 static_cast<std::size_t>(grid.patch.size);
  if (nodes.sums.extent(0) < n * sum_components)
    nodes.sums = ArrayView<double>(
        Kokkos::ViewAllocateWithoutInitializing("sums"), 5 * n * sum_components / 4
    );
  if (nodes.motion.extent(0) < n * motion_components)
    nodes.motion = ArrayView<double>(
        Kokkos::ViewAllocateWithoutInitializing("motion"), 5 * n * motion_components / 4
    );
  const std::size_t used = first_sum(grid.patch, grid.active);
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
        Kernel{PatchFrame<decltype(mode)::dimensions>(grid), particles, nodes.sums}
    );
  });
}

}  // namespace barreno
