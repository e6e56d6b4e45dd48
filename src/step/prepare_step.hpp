// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// What a step starts with; the same on every rank.
struct StepStart {
  double dt = 0.0;    ///< its size, before solve_motion retries with a smaller one [time]
  int interrupt = 0;  ///< signal that some rank received
  int set_by = 0;     ///< row of StepLimits
};

/// Before the forces of a step: tiles go to ranks by cost, the jet's slugs whose time has come are
/// launched, every particle gets its cell and the step its size, at most to `next_time`.
///
/// @post every particle is on the rank that owns its tile, and rows are in order (place_particles)
StepStart prepare_step(const Scene& scene, double next_time, State& state);

}  // namespace barreno
