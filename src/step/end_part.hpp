// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/step_result.hpp"
#include "step/tally_step.hpp"

namespace barreno {

/// After a part of a step (Subcycling) that is not its last: tiles within their own steps go on, or
/// all end theirs, if a particle came into one of them, the stable step fell or the run must stop.
///
/// @param dt  of the part [time]
void end_or_carry_steps(
    const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result
);

/// Before the next part: particles that are too far from their tiles get others, their ranks and
/// their places in the order (StrayRule).
void prepare_next_part(State& state);

}  // namespace barreno
