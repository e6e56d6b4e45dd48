// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/accelerate_particles.hpp"
#include "step/filter_velocity.hpp"
#include "step/mirror_walls.hpp"
#include "step/solve_contact.hpp"
#include "step/update_stress.hpp"

#include <vector>

namespace barreno {

/// What a step finds for the ledger on its way, this rank's part.
struct StepTally {
  GridTally grid;
  RigidTally rigid;
  WholeSum applied_work;  ///< of loads and body force
  FilterTally filter;
  ParticleTally moved;
  StressTally stress;
};

/// Each term where it arises; see Ledger.
void tally_step(const StepTally& tally, State& state);

/// Particles that the step has advanced, and those that it has left as they were (Dormancy).
void tally_particle_steps(State& state);

}  // namespace barreno
