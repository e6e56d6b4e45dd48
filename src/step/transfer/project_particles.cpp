// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/project_particles.hpp"

#include "base/launch.hpp"
#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/transfer/space_stress.hpp"

namespace barreno {
namespace {

using Sums = Pack<sum_components>;

/// What the particles of a batch give to the grid.
template <class M>
struct GivenColumns : StressColumns<M> {
  BatchColumns<M::dimensions> velocity;

  KOKKOS_INLINE_FUNCTION GivenColumns(const Particles& particles, const BatchRows& rows)
      : StressColumns<M>(particles, rows) {
    velocity.load(particles.velocity, rows);
  }
};

/// Contributions of one particle to its nodes: S times mass and momentum, and the resultants of its
/// stress, -V (sigma - q I), times the gradients of S.
template <class M>
struct Contributions;

/// In two dimensions one pack holds all of it.
template <class M>
struct ContributionsInPlane {
  enum { mass, momentum_x, momentum_y, force_xx, force_xy, force_yy, force_hoop, nothing };
  alignas(sizeof(Sums)) double value[sum_components];

  KOKKOS_FORCEINLINE_FUNCTION void find(const GivenColumns<M>& particles, int p) {
    const Sym3 stress = particles.space_stress(p);
    const double q = particles.viscous_pressure(p);
    const double volume = particles.volume(p);
    const double m = particles.mass(p);
    value[mass] = m;
    value[momentum_x] = m * particles.velocity(p, 0);
    value[momentum_y] = m * particles.velocity(p, 1);
    value[force_xx] = -volume * (stress.xx - q);
    value[force_xy] = -volume * stress.xy;
    value[force_yy] = -volume * (stress.yy - q);
    value[force_hoop] = M::hoop ? -volume * (stress.zz - q) : 0.0;
    value[nothing] = 0.0;
  }
  template <class Support>
  KOKKOS_INLINE_FUNCTION void add_to(Sums* patch, const Patch& sizes, const Support& support)
      const {
    constexpr int o = nothing;
    const Sums& g = *as_packs<sum_components>(value);
    support.template add_to<M::hoop>(
        patch,
        sizes,
        select<mass, momentum_x, momentum_y, o, o, o, o, o>(g),
        {select<o, o, o, force_xx, force_xy, o, o, o>(g),
         select<o, o, o, force_xy, force_yy, o, o, o>(g)},
        select<o, o, o, force_hoop, o, o, o, o>(g)
    );
  }
};
template <>
struct Contributions<Axisymmetric> : ContributionsInPlane<Axisymmetric> {};
template <>
struct Contributions<PlaneStrain> : ContributionsInPlane<PlaneStrain> {};

/// In three dimensions the forces across y and z go into a second pack.
template <>
struct Contributions<ThreeDimensional> {
  enum { mass, momentum_x, momentum_y, momentum_z, force_xx, force_xy, force_xz, nothing };
  enum { again_xy, force_yy, force_yz, again_xz, force_zz };
  alignas(sizeof(Sums)) double value[sum_components];
  double more[sum_components];

  KOKKOS_FORCEINLINE_FUNCTION void find(const GivenColumns<ThreeDimensional>& particles, int p) {
    const Sym3 stress = particles.space_stress(p);
    const double q = particles.viscous_pressure(p);
    const double volume = particles.volume(p);
    const double m = particles.mass(p);
    value[mass] = m;
    value[momentum_x] = m * particles.velocity(p, 0);
    value[momentum_y] = m * particles.velocity(p, 1);
    value[momentum_z] = m * particles.velocity(p, 2);
    value[force_xx] = -volume * (stress.xx - q);
    value[force_xy] = more[again_xy] = -volume * stress.xy;
    value[force_xz] = more[again_xz] = -volume * stress.zx;
    value[nothing] = more[nothing] = 0.0;
    more[force_yy] = -volume * (stress.yy - q);
    more[force_yz] = -volume * stress.yz;
    more[force_zz] = -volume * (stress.zz - q);
    more[5] = more[6] = 0.0;
  }
  template <class Support>
  KOKKOS_INLINE_FUNCTION void add_to(Sums* patch, const Patch& sizes, const Support& support)
      const {
    constexpr int o = nothing;
    const Sums& g = *as_packs<sum_components>(value);
    const Sums& h = *as_packs<sum_components>(more);
    support.template add_to<false>(
        patch,
        sizes,
        select<mass, momentum_x, momentum_y, momentum_z, o, o, o, o>(g),
        {select<o, o, o, o, force_xx, force_xy, force_xz, o>(g),
         select<o, o, o, o, again_xy, force_yy, force_yz, o>(h),
         select<o, o, o, o, again_xz, force_yz, force_zz, o>(h)},
        Sums{}
    );
  }
};

template <class M, class S>
struct ProjectParticles {
  PatchFrame<M::dimensions> frame;
  Particles particles;
  Nodes nodes;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (nodes.keeps_sums(tile)) return;
    Sums* const patch = as_packs<sum_components>(&nodes.sums(first_sum(frame.patch, tile)));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
      batch(tile, BatchRows(particles.order, k, end), patch);
  }

  KOKKOS_INLINE_FUNCTION void batch(int tile, const BatchRows& rows, Sums* patch) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
    Contributions<M> contributions[rows_per_batch];
    const GivenColumns<M> given(particles, rows);
    BARRENO_IVDEP
    for (int k = 0; k < rows_per_batch; ++k) contributions[k].find(given, k);
    for (int k = 0; k < rows.count; ++k)
      contributions[k].add_to(patch, frame.patch, supports.get(k));
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
  const auto width = static_cast<std::size_t>(motion_components(grid.patch.dimensions));
  if (nodes.motion.extent(0) < n * width)
    nodes.motion =
        ArrayView<double>(Kokkos::ViewAllocateWithoutInitializing("motion"), 5 * n * width / 4);
  const Nodes all = nodes;
  const Patch patch = grid.patch;
  launch(
      "clear_nodes",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (all.keeps_sums(tile)) return;
        double* const values = &all.sums(first_sum(patch, tile));
        for (int i = 0; i < patch.size * sum_components; ++i) values[i] = 0.0;
      }
  );
}

void project_particles(const Grid& grid, const Particles& particles, Nodes& nodes) {
  const Region region("project_particles");
  visit_kernels(grid, [&](auto mode, auto shape) {
    using Kernel = ProjectParticles<decltype(mode), decltype(shape)>;
    launch(
        "project_particles",
        range(grid.active),
        Kernel{PatchFrame<decltype(mode)::dimensions>(grid), particles, nodes}
    );
  });
}

}  // namespace barreno
