// SPDX-License-Identifier: BSD-3-Clause
#include "step/apply_loads.hpp"

#include "step/loads/load_pressures.hpp"
#include "step/loads/project_body_force.hpp"
#include "step/loads/project_loads.hpp"
#include "step/loads/release_torn_faces.hpp"
#include "step/loads/surface_pressures.hpp"

#include <tuple>

namespace barreno {

void apply_loads(const ExternalForces& forces, State& state) {
  const auto& [grid, sets, nodes] = std::tie(state.grid, state.particles, state.nodes);
  set_load_pressures(forces.loads, state.cavities, state.clock.time, state.loads);
  state.ledger.unloaded += release_torn_faces(grid, nodes, sets, state.loads);  // debris has none
  project_loads(tractions_of(state), forces.materials);
  project_surface_pressures(tractions_of(state));
  project_body_force(forces.body_force, state.clock, grid, sets, nodes);
}

ReproducibleSum tally_applied_loads(const BodyForceSpec& body_force, State& state) {
  const Tractions tractions = tractions_of(state);
  ReproducibleSum work = tally_loads(tractions, state.dormancy, state.ledger);
  work += tally_surface_pressures(tractions, state.ledger);
  work += tally_body_force(body_force, state.clock, state.grid, state.particles, state.ledger);
  grow_cavities(tractions, state.cavities);
  return work;
}

}  // namespace barreno
