// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/filter_velocity.hpp"

#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "step/boundary/mirror_nodes.hpp"
#include "step/nodes/sum_halos.hpp"
#include "step/transfer/interpolate_motion.hpp"
#include "step/transfer/project_particles.hpp"
#include "step/transfer/project_sets.hpp"

namespace barreno {
namespace {

/// r_1 = v_p - S v_I: v_I before the forces is v_I' less its increment.
void find_residual(const Particles& particles) {
  const FieldView v = particles.velocity.values;
  const FieldView motion = particles.grid_motion.values;
  const FieldView residual = particles.residual.values;
  const int dimensions = particles.velocity.components;
  for_each_row(
      "find_residual",
      {0, particles.count},
      KOKKOS_LAMBDA(const int p) {
        for (int d = 0; d < dimensions; ++d)
          residual(p, d) = v(p, d) - (motion(p, d) - motion(p, dimensions + d));
      }
  );
}

/// r_k = r_k-1 - S S+ r_k-1.
void reduce_residual(const Particles& particles) {
  const FieldView correction = particles.second_pass_motion.values;
  const FieldView residual = particles.residual.values;
  const int dimensions = particles.velocity.components;
  for_each_row(
      "reduce_residual",
      {0, particles.count},
      KOKKOS_LAMBDA(const int p) {
        for (int d = 0; d < dimensions; ++d) residual(p, d) -= correction(p, d);
      }
  );
}

/// The rows of a set with the residual for a velocity, and room for what it receives from the grid.
Particles with_residual(const Particles& particles) {
  Particles asking = particles;
  asking.velocity = particles.residual;
  asking.grid_motion = particles.second_pass_motion;
  asking.increment = particles.second_pass_increment;
  return asking;
}

/// One application of S S+ to the residuals of all sets.
struct SmoothResiduals {
  const FilterRule& filter;
  const Grid& grid;
  const VelocityFields& fields;
  const Dormancy& dormancy;
  const std::vector<Particles>& sets;
  std::vector<Nodes>& nodes;

  Nodes& nodes_of(const Particles& particles) const {
    return nodes[static_cast<std::size_t>(particles.field)];
  }

  void project() const {
    for (Nodes& field : nodes) clear_nodes(grid, field);
    for (const Particles& particles : sets)
      if (!particles.rigid) project_particles(grid, with_residual(particles), nodes_of(particles));
    drop_forces(grid, nodes);
    sum_halos(filter.symmetry, grid, nodes);
  }

  /// @return the axial impulse of the conditions on S+ r
  ReproducibleSum solve() const {
    const VelocityRule& rule = filter.rule;
    ReproducibleSum impulse;
    for (std::size_t f = 0; f < nodes.size(); ++f) {
      if (fields.rigid_body[f] >= 0) continue;
      GridTally part = solve_velocity(grid, rule, {}, nodes[f]);
      mirror_velocities(filter.symmetry, grid, rule.grid_share, nodes[f], part);
      impulse += part.filter_impulse;
    }
    return impulse;
  }

  void interpolate() const {
    for (const Particles& particles : sets) {
      if (particles.rigid) continue;
      Particles asking = with_residual(particles);
      interpolate_motion(grid, dormancy, {}, nodes_of(particles), asking);
    }
  }
};

/// v_p <- v_p - r_m; returns the change of the set's kinetic energy.
ReproducibleSum take_residual(Particles& particles) {
  const Particles rows = particles;
  ReproducibleSum change;
  launch_reduction(
      "take_residual",
      range((rows.count + rows_per_chunk - 1) / rows_per_chunk),
      KOKKOS_LAMBDA(const int chunk, ReproducibleSum& sum) {
        const int begin = chunk * rows_per_chunk;
        for (int p = begin; p < begin + rows_per_chunk && p < rows.count; ++p) {
          double square = 0.0;
          for (int d = 0; d < rows.velocity.components; ++d) {
            const double v = rows.velocity(p, d);
            const double w = v - rows.residual(p, d);
            square += w * w - v * v;
            rows.velocity(p, d) = w;
          }
          sum += 0.5 * rows.mass(p) * square;
        }
        sum.carry();
      },
      TallyReducer<ReproducibleSum>(change)
  );
  return change;
}

}  // namespace

FilterTally filter_velocity(
    const FilterRule& filter,
    const Grid& grid,
    const VelocityFields& fields,
    const Dormancy& dormancy,
    std::vector<Nodes>& nodes,
    std::vector<Particles>& sets,
    Effort& effort
) {
  if (filter.powers == 0) return {};
  const Region region("filter_velocity");
  FilterTally tally;
  for (const Particles& particles : sets)
    if (!particles.rigid) find_residual(particles);
  const SmoothResiduals smooth{filter, grid, fields, dormancy, sets, nodes};
  for (int k = 2; k <= filter.powers; ++k) {
    const Stopwatch watch;
    smooth.project();
    tally.condition_impulse = smooth.solve();
    smooth.interpolate();
    effort.node_seconds += watch.seconds();
    for (const Particles& particles : sets)
      if (!particles.rigid) reduce_residual(particles);
  }
  for (Particles& particles : sets)
    if (!particles.rigid) tally.kinetic += take_residual(particles);
  return tally;
}

}  // namespace barreno
