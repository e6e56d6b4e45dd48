// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "state/state.hpp"

namespace barreno {

/// Kinetic energy of the particles on both sides of a step, mass and axial momentum after it.
struct ParticleTally {
  double kinetic_before = 0.0, kinetic_after = 0.0;
  double mass = 0.0, momentum = 0.0;
};

inline void add(const ParticleTally& part, ParticleTally& sum) {
  sum.kinetic_before += part.kinetic_before;
  sum.kinetic_after += part.kinetic_after;
  sum.mass += part.mass;
  sum.momentum += part.momentum;
}

/// Commit the grid's velocity to the particles. docs/method.md (2.7)
///
///   v_p <- (1 - a) (v_p + dv) + a v,   a the PIC fraction
ParticleTally accelerate_particles(const Scene& scene, Rows rows, Particles& particles);

}  // namespace barreno
