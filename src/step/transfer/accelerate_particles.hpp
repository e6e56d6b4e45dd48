// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"
#include "base/rows.hpp"
#include "grid/grid.hpp"
#include "state/particles.hpp"
#include "step/grid_share.hpp"

namespace barreno {

/// Kinetic energy that the particles gain in a step, and what they have after it: kinetic energy,
/// mass, axial momentum.
struct ParticleTally {
  ReproducibleSum gain, kinetic, mass, momentum;
};

KOKKOS_INLINE_FUNCTION void add(const ParticleTally& part, ParticleTally& sum) {
  sum.gain += part.gain;
  sum.kinetic += part.kinetic;
  sum.mass += part.mass;
  sum.momentum += part.momentum;
}

/// Commit the grid's velocity to the particles. docs/method.md (2.7)
///
///   v_p <- (1 - a) (v_p + dv) + a v,   a the grid's share
ParticleTally accelerate_particles(
    const StepSpec& step, const Grid& grid, Rows rows, Particles& particles
);

/// Mass, axial momentum and kinetic energy of all particles as they are.
ParticleTally tally_momentum(const Particles& particles);

}  // namespace barreno
