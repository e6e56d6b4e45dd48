// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"
#include "shape/patch_frame.hpp"
#include "shape/visit_kernels.hpp"
#include "state/ledger.hpp"
#include "state/load_table.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"

#include <vector>

namespace barreno {

/// What kernels of loads need of one set of particles.
template <class M, class S>
struct LoadedSet {
  PatchFrame<M::dimensions> frame;
  LoadTable loads;
  Particles particles;
  Nodes nodes;
};

/// visit(LoadedSet of a set, as its kernels are compiled) for every deformable set that has a field
/// of loads: loaded_faces or surface_share.
template <class Visitor>
void for_each_loaded_set(
    const Grid& grid,
    const LoadTable& loads,
    const std::vector<Particles>& sets,
    const std::vector<Nodes>& nodes,
    Field Particles::*needed,
    Visitor&& visit
) {
  visit_kernels(grid, [&](auto mode, auto shape) {
    using M = decltype(mode);
    for (const Particles& particles : sets)
      if (!particles.rigid && (particles.*needed).components > 0)
        visit(LoadedSet<M, decltype(shape)>{
            PatchFrame<M::dimensions>(grid),
            loads,
            particles,
            nodes[static_cast<std::size_t>(particles.field)]});
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
