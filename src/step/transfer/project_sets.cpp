// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/project_sets.hpp"

#include "base/launch.hpp"
#include "step/transfer/project_affine.hpp"
#include "step/transfer/project_particles.hpp"

namespace barreno {

void project_sets(
    const Grid& grid, const std::vector<Particles>& sets, std::vector<Nodes>& fields, Effort& effort
) {
  const Stopwatch watch;
  for (Nodes& nodes : fields) clear_nodes(grid, nodes);
  for (const Particles& particles : sets) {
    Nodes& nodes = fields[static_cast<std::size_t>(particles.field)];
    project_particles(grid, particles, nodes);
    project_affine(grid, particles, nodes);
  }
  effort.node_seconds += watch.seconds();
}

void drop_forces(const Grid& grid, std::vector<Nodes>& fields) {
  const Patch patch = grid.patch;
  for (const Nodes& nodes : fields) {
    const ArrayView<double> sums = nodes.sums;
    launch(
        "drop_forces",
        range(grid.active),
        KOKKOS_LAMBDA(const int tile) {
          double* const values = &sums(first_sum(patch, tile));
          for (int slot = 0; slot < patch.size; ++slot)
            for (int i = first_force(patch.dimensions); i < sum_components; ++i)
              values[slot * sum_components + i] = 0.0;
        }
    );
  }
}

}  // namespace barreno
