// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "scene/velocity_fields.hpp"
#include "state/contact_nodes.hpp"
#include "state/dormancy.hpp"
#include "state/effort.hpp"
#include "state/ledger.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"
#include "state/pore_flow_state.hpp"
#include "state/reaction.hpp"

#include <limits>
#include <vector>

namespace barreno {

struct Clock {
  double time = 0.0;
  double dt = 0.0;  ///< of the last step
  long step = 0;
};

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
  std::vector<double> cavities;  ///< volume of the pore fluid of each load, the same on all ranks
  std::size_t next_slug = 0;     ///< first jet slug that is still to be launched
  std::vector<ParticleId> slug_ids;  ///< first id of every slug
  double stable_step =
      std::numeric_limits<double>::infinity();  ///< of this rank, by the last stress update [time]
  Dormancy dormancy;
  /// Of the active tiles: 1 where a particle may have a loaded face (release_torn_faces).
  std::vector<unsigned char> loaded_tiles;
  double particle_steps = 0.0;  ///< sum over steps of the particles advanced on this rank
  double skipped_steps = 0.0;   ///< of those that were left as they were
  Effort effort;
  Sharing sharing;
};

}  // namespace barreno
