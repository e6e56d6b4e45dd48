// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/boundary/mirror_nodes.hpp"
#include "step/contact/solve_contact.hpp"
#include "step/particles/update_stress.hpp"
#include "step/transfer/accelerate_particles.hpp"
#include "step/transfer/filter_velocity.hpp"

#include <vector>

namespace barreno {

/// What a step finds for the ledger on its way, this rank's part.
struct StepTally {
  GridTally grid;
  RigidTally rigid;
  ReproducibleSum applied_work;  ///< of loads and body force
  FilterTally filter;
  ParticleTally moved;
  StressTally stress;
};

/// Each term where it arises; see Ledger.
void tally_step(const StepTally& tally, OwnLedger& ledger, std::vector<Reaction>& reactions);

/// Particles that the step has advanced, or a part of it, and those that all of it has skipped
/// (Dormancy).
void tally_particle_steps(
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    const Subcycling& subcycling,
    double& particle_steps,
    double& skipped_steps
);

/// The same particles by the cells and by the step of their tiles, where these differ at all.
void tally_step_shares(
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    const Subcycling& subcycling,
    StepShares& shares
);

}  // namespace barreno
