// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/filter_velocity.hpp"

#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "step/boundary/apply_symmetry.hpp"
#include "step/grid/solve_velocity.hpp"
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

/// S S+ r of all sets; returns the axial impulse of the conditions on S+ r.
ReproducibleSum smooth_residuals(const Scene& scene, State& state) {
  const Stopwatch watch;
  for (Nodes& nodes : state.nodes) clear_nodes(state.grid, nodes);
  for (const Particles& particles : state.particles)
    if (!particles.rigid)
      project_particles(
          state.grid,
          with_residual(particles),
          state.nodes[static_cast<std::size_t>(particles.field)]
      );
  drop_forces(state.grid, state.nodes);
  const SymmetryPlanes symmetry(scene.conditions, state.grid);
  sum_halos(symmetry, state.grid, state.nodes);
  const VelocityRule rule{
      homogeneous(state.conditions),
      0.0,
      GridShare(scene.step),
      NodeScaleRule(scene.materials, scene.grid)};
  ReproducibleSum impulse;
  for (std::size_t f = 0; f < state.nodes.size(); ++f) {
    if (state.fields.rigid_body[f] >= 0) continue;
    Nodes& nodes = state.nodes[f];
    GridTally part = solve_velocity(state.grid, rule, {}, nodes);
    apply_symmetry_to_velocities(symmetry, state.grid, rule.grid_share, nodes, part);
    impulse += part.filter_impulse;
  }
  for (const Particles& particles : state.particles) {
    if (particles.rigid) continue;
    Particles asking = with_residual(particles);
    const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
    interpolate_motion(state.grid, state.dormancy, nodes, asking);
  }
  state.effort.node_seconds += watch.seconds();
  return impulse;
}

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

FilterTally filter_velocity(const Scene& scene, State& state) {
  if (scene.step.transfer != Transfer::xpic) return {};
  const Region region("filter_velocity");
  FilterTally tally;
  for (const Particles& particles : state.particles)
    if (!particles.rigid) find_residual(particles);
  for (int k = 2; k <= scene.step.xpic_order; ++k) {
    tally.condition_impulse = smooth_residuals(scene, state);
    for (const Particles& particles : state.particles)
      if (!particles.rigid) reduce_residual(particles);
  }
  for (Particles& particles : state.particles)
    if (!particles.rigid) tally.kinetic += take_residual(particles);
  return tally;
}

}  // namespace barreno
