// SPDX-License-Identifier: BSD-3-Clause
#include "step/project_sets.hpp"

#include "grid/halo.hpp"
#include "step/project_affine.hpp"
#include "step/project_particles.hpp"

namespace barreno {

void project_sets(const Scene& scene, State& state) {
  const Stopwatch watch;
  for (Nodes& nodes : state.nodes) clear_nodes(state.grid, nodes);
  for (const Particles& particles : state.particles) {
    Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
    project_particles(scene, state.grid, particles, nodes);
    project_affine(scene, state.grid, particles, nodes);
  }
  state.effort.node_seconds += watch.seconds();
}

void drop_forces(State& state) {
  const Patch& patch = state.grid.patch;
  const std::size_t end = first_sum(patch, state.grid.active);
  for (Nodes& nodes : state.nodes)
    for (std::size_t node = 0; node < end; node += sum_components)
      for (int i = first_force(patch.dimensions); i < sum_components; ++i)
        nodes.sums(node + static_cast<std::size_t>(i)) = 0.0;
}

void join_nodes(const Scene& scene, State& state) {
  for (Nodes& nodes : state.nodes) fold_walls(scene, state.grid, nodes);
  for (const Nodes& field : state.nodes)
    exchange_halo(state.grid, field.sums, state.grid.patch.size * sum_components);
}

}  // namespace barreno
