// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"
#include "shape/patch_frame.hpp"
#include "shape/visit_kernels.hpp"
#include "step/loads/tractions.hpp"

namespace barreno {

/// What kernels of loads need of one set of particles.
template <class M, class S>
struct LoadedSet {
  PatchFrame<M::dimensions> frame;
  LoadTable loads;
  Particles particles;
  Nodes nodes;
  Subcycling subcycling;

  /// Whether a tile ends its step with this part: its loads, which stay over the step, then count.
  KOKKOS_INLINE_FUNCTION bool ends_step(int tile) const {
    return !subcycling.on() || subcycling.ends(tile) != 0;
  }
  /// What its nodes do over the step that a tile ends.
  KOKKOS_INLINE_FUNCTION const double* motion_of(int tile) const {
    const bool whole = subcycling.takes_whole(tile) &&
                       (subcycling.solved(tile) != 0 || subcycling.gained(tile) != 0);
    return &(whole ? subcycling.whole : nodes.motion)(first_motion(frame.patch, tile));
  }
};

/// visit(LoadedSet of a set, as its kernels are compiled) for every deformable set that has a field
/// of loads: loaded_faces or surface_share.
template <class Visitor>
void for_each_loaded_set(const Tractions& tractions, Field Particles::*needed, Visitor&& visit) {
  const Grid& grid = tractions.grid;
  visit_kernels(grid, [&](auto mode, auto shape) {
    using M = decltype(mode);
    for (const Particles& particles : tractions.sets)
      if (!particles.rigid && (particles.*needed).components > 0)
        visit(LoadedSet<M, decltype(shape)>{
            PatchFrame<M::dimensions>(grid),
            tractions.loads,
            particles,
            tractions.nodes[static_cast<std::size_t>(particles.field)],
            tractions.subcycling});
  });
}

/// What loads do to the bodies in a step.
struct LoadTally {
  ReproducibleSum work, impulse;
};
KOKKOS_INLINE_FUNCTION void add(const LoadTally& part, LoadTally& sum) {
  sum.work += part.work;
  sum.impulse += part.impulse;
}

}  // namespace barreno
