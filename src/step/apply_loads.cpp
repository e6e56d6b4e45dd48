// SPDX-License-Identifier: BSD-3-Clause
#include "step/apply_loads.hpp"

#include "step/loads/load_pressures.hpp"
#include "step/loads/project_body_force.hpp"
#include "step/loads/project_loads.hpp"
#include "step/loads/release_torn_faces.hpp"
#include "step/loads/surface_pressures.hpp"

#include <tuple>

namespace barreno {

void apply_loads(const Scene& scene, State& state) {
  const auto& [grid, sets, nodes] = std::tie(state.grid, state.particles, state.nodes);
  set_load_pressures(scene.loads, state.cavities, state.clock.time, state.loads);
  state.ledger.unloaded += release_torn_faces(grid, nodes, sets, state.loads);  // debris has none
  project_loads(grid, state.loads, scene.materials, sets, nodes);
  project_surface_pressures(grid, state.loads, sets, nodes);
  project_body_force(scene.body_force, state.clock, grid, sets, nodes);
}

ReproducibleSum tally_applied_loads(const Scene& scene, State& state) {
  const auto& [grid, sets, nodes] = std::tie(state.grid, state.particles, state.nodes);
  ReproducibleSum work = tally_loads(grid, state.loads, sets, nodes, state.dormancy, state.ledger);
  work += tally_surface_pressures(grid, state.loads, sets, nodes, state.ledger);
  work += tally_body_force(scene.body_force, state.clock, grid, sets, state.ledger);
  grow_cavities(grid, state.loads, sets, nodes, state.cavities);
  return work;
}

}  // namespace barreno
