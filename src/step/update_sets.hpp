// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/step_result.hpp"
#include "step/tally_step.hpp"

namespace barreno {

/// What the update of all particles that forces move reads, and what it writes.
struct SetUpdate {
  const std::vector<MaterialSpec>& materials;
  const StepSpec& step;
  const Grid& grid;  ///< with the step of every tile (set_tile_steps)
  const Dormancy& dormancy;
  std::vector<Particles>& sets;
  OwnLedger& ledger;  ///< its `held`, `clipped` and `materials`
  Effort& effort;
  double end;       ///< of the step [time]
  bool own_fields;  ///< contact gives sets velocity fields of their own
};
SetUpdate set_update(
    const std::vector<MaterialSpec>& materials, const StepSpec& step, double end, State& state
);

/// What is done to all particles that forces move, block after block (base/rows.hpp): each function
/// takes the verbs that its order of the step has neighbours. docs/method.md (2.7-2.9)
///
/// Those that update stresses tally them by set, give inverted domains to the particle policy, and
/// say in `result` which particle failed whose policy is to stop.

/// v, x, F, sigma.
void update_sets(const SetUpdate& update, StepTally& tally, StepResult& result);
/// v.
void accelerate_sets(const SetUpdate& update, StepTally& tally);
/// x, F, sigma.
void move_and_strain_sets(const SetUpdate& update, StepTally& tally, StepResult& result);
/// F, sigma.
void strain_sets(const SetUpdate& update, StepTally& tally, StepResult& result);
/// v, x.
void accelerate_and_move_sets(const SetUpdate& update, StepTally& tally);

/// Rigid bodies by their own motion.
void move_rigid_sets(
    const RigidMotions& motions,
    double time,
    const Grid& grid,
    std::vector<Particles>& sets,
    StepTally& tally
);

/// The verdict of all ranks; only materials whose failure stops the run ask for it.
void agree_on_failure(
    const std::vector<MaterialSpec>& materials, const Teuchos::Comm<int>& comm, StepResult& result
);

}  // namespace barreno
