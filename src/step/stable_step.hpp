// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/place_particles.hpp"

namespace barreno {

/// Smallest step that the particles now in the state allow, from their modulus and speed: for
/// particles that had no stress update yet (start of a run, launched jet) [time].
double stable_step_of_rows(const Scene& scene, const Particles& particles, int first_row);

/// The fraction f of the step that is stable with damping a, where `dt` is the fraction of the one
/// without, 2 / omega:
///
///   dt = 4 f / (a + sqrt(a^2 + 4 omega^2))
///
/// With v' = (1 - a dt) v - omega^2 dt x and x' = x + dt v' that is where an eigenvalue reaches -1
/// (tests/unit/step/test_stable_step.cpp); much damping leaves 2 f / a [time].
double damped_step(double dt, double damping, double fraction);

/// The size of the next step, the same on every rank, and what else the ranks must agree on: one
/// reduction.
///
///   dt = min(stable step, growth limit * last dt, largest step, time to the next event)
///
/// @param[in,out] placement  in: this rank's; out: of any rank
/// @param next_time          the step ends there at the latest, exactly [time]
double agree_on_step(const Scene& scene, double next_time, Placement& placement, State& state);

}  // namespace barreno
