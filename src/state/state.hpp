// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "scene/velocity_fields.hpp"
#include "state/cavity.hpp"
#include "state/clock.hpp"
#include "state/contact_nodes.hpp"
#include "state/dormancy.hpp"
#include "state/effort.hpp"
#include "state/jet_state.hpp"
#include "state/ledger.hpp"
#include "state/load_table.hpp"
#include "state/node_conditions.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"
#include "state/pore_flow_state.hpp"
#include "state/reaction.hpp"
#include "state/rigid_motions.hpp"
#include "state/step_limits.hpp"
#include "state/step_shares.hpp"
#include "state/subcycling.hpp"

#include <limits>
#include <vector>

namespace barreno {

/// All that changes during a run; what a restart holds. Nodes are scratch of the step.
struct State {
  Grid grid;
  std::vector<Particles> particles;  ///< one set per material, in the order of Scene::materials
  VelocityFields fields;
  std::vector<Nodes> nodes;  ///< by velocity field
  ContactNodes contact;
  Clock clock;
  OwnLedger ledger;
  PoreFlowState pore_flow;
  std::vector<Reaction> reactions;  ///< of rigid bodies, in the order of Scene::bodies
  std::vector<Cavity> cavities;     ///< by load
  LoadTable loads;
  NodeConditions conditions;
  RigidMotions rigid_motions;  ///< in the order of `reactions`
  JetState jet;
  double stable_step =
      std::numeric_limits<double>::infinity();  ///< of this rank, by the last stress update [time]
  Dormancy dormancy;
  Subcycling subcycling;
  double particle_steps = 0.0;  ///< sum over steps of the particles advanced on this rank
  double skipped_steps = 0.0;   ///< of those that were left as they were
  StepShares step_shares;       ///< of particle_steps
  StepLimits step_limits;
  std::vector<double> agreed;  ///< room for agree_on_stable_step, a value more for every set
  std::vector<double> resumed_tile_steps;  ///< last_tile_steps() of a checkpoint, until a step
  Effort effort;
  LoadBalance sharing;
};

}  // namespace barreno
