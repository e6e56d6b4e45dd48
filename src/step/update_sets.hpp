// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/advance.hpp"
#include "step/tally_step.hpp"

namespace barreno {

/// What is done to all particles that forces move, block after block (base/rows.hpp): each function
/// takes the verbs that its order of the step has neighbours. docs/method.md (2.7-2.9)
///
/// Those that update stresses tally them by set, give inverted domains to the particle policy, and
/// say in `result` which particle failed whose policy is to stop.

/// v, x, F, sigma.
void update_sets(const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result);
/// v.
void accelerate_sets(const Scene& scene, double dt, State& state, StepTally& tally);
/// x, F, sigma.
void move_and_strain_sets(
    const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result
);
/// F, sigma.
void strain_sets(const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result);
/// v, x.
void accelerate_and_move_sets(const Scene& scene, double dt, State& state, StepTally& tally);

/// Rigid bodies by their own motion.
void move_rigid_sets(const Scene& scene, double dt, State& state, StepTally& tally);

/// The verdict of all ranks; only scenes in which a failure stops the run pay for it.
void agree_on_failure(const Scene& scene, const State& state, StepResult& result);

}  // namespace barreno
