// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "state/state.hpp"

namespace barreno {

/// Kinetic energy that the particles gain in a step, and what they have after it: kinetic energy,
/// mass, axial momentum.
struct ParticleTally {
  WholeSum gain, kinetic, mass, momentum;
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
ParticleTally accelerate_particles(const Scene& scene, double dt, Rows rows, Particles& particles);

/// Share of the grid's own velocity in a particle's new one: the PIC fraction, and damping for what
/// of v_p the grid does not see. Forces of damping act on nodes alone; particles that move against
/// each other within their cells, seen by no node, would go on for ever.
double grid_share(const StepSpec& step, double dt);

}  // namespace barreno
