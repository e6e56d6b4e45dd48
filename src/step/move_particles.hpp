// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "state/state.hpp"

namespace barreno {

/// Kinetic energy of the particles on both sides of a move, mass and axial momentum after it.
struct ParticleTally {
  double kinetic_before = 0.0, kinetic_after = 0.0;
  double mass = 0.0, momentum = 0.0;
};

/// Commit the grid's motion to position and velocity. docs/method.md (2.7)
///
///   v_p <- (1 - a) (v_p + dv) + a v,   x_p <- x_p + dt v,   a the PIC fraction
///
/// In axisymmetry the radius follows the hoop stretch, r_p <- r_p exp(dt L_hoop): r_p / F_hoop
/// stays the radius at the start exactly, and no particle crosses the axis. (The r-weighted average
/// velocity belongs to the centre of mass of the ring, not to r_p, and would drift from F near the
/// axis.)
ParticleTally move_particles(const Scene& scene, double dt, Rows rows, Particles& particles);

}  // namespace barreno
