// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/place_particles.hpp"

namespace barreno {

/// Smallest step that the particles now in the state allow, from their modulus and speed: for
/// particles that had no stress update yet (start of a run, launched jet) [time].
double stable_step_of_rows(const Scene& scene, const Particles& particles, int first_row);

/// The size of the next step, the same on every rank, and what else the ranks must agree on: one
/// reduction.
///
///   dt = min(stable step, growth limit * last dt, largest step, time to the next event)
///
/// @param[in,out] placement  in: this rank's; out: of any rank
/// @param next_time          the step ends there at the latest, exactly [time]
double agree_on_step(const Scene& scene, double next_time, Placement& placement, State& state);

}  // namespace barreno
