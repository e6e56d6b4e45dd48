// SPDX-License-Identifier: BSD-3-Clause
#include "step/filter_velocity.hpp"

#include "base/region.hpp"
#include "base/rows.hpp"
#include "step/interpolate_motion.hpp"
#include "step/project_particles.hpp"
#include "step/project_sets.hpp"
#include "step/solve_velocity.hpp"

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
  const FieldView correction = particles.again_motion.values;
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

/// The rows of a set with the residual for a velocity, and room for what the grid says to it.
Particles with_residual(const Particles& particles) {
  Particles asking = particles;
  asking.velocity = particles.residual;
  asking.grid_motion = particles.again_motion;
  asking.increment = particles.again_increment;
  return asking;
}

/// S S+ r of all sets; returns the axial impulse of the conditions on S+ r.
WholeSum smooth_residuals(const Scene& scene, double dt, State& state) {
  const Stopwatch watch;
  for (Nodes& nodes : state.nodes) clear_nodes(state.grid, nodes);
  for (const Particles& particles : state.particles)
    if (!particles.rigid)
      project_particles(
          scene,
          state.grid,
          with_residual(particles),
          state.nodes[static_cast<std::size_t>(particles.field)]
      );
  drop_forces(state);
  join_nodes(scene, state);
  const NodeConditions conditions = at_rest(node_conditions(scene, state.grid, state.clock, dt));
  WholeSum impulse;
  for (std::size_t f = 0; f < state.nodes.size(); ++f) {
    if (state.fields.rigid_body[f] >= 0) continue;
    Nodes& nodes = state.nodes[f];
    GridTally part = solve_velocity(scene, state.grid, conditions, dt, 0.0, {}, nodes);
    unfold_walls(scene, state.grid, dt, nodes, part);
    impulse += part.filter_impulse;
  }
  for (const Particles& particles : state.particles) {
    if (particles.rigid) continue;
    Particles asking = with_residual(particles);
    const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
    interpolate_motion(scene, state, nodes, dt, asking);
  }
  state.effort.node_seconds += watch.seconds();
  return impulse;
}

/// v_p <- v_p - r_m; returns the change of the set's kinetic energy.
WholeSum take_residual(Particles& particles) {
  WholeSum change;
  for (int p = 0; p < particles.count; ++p) {
    double square = 0.0;
    for (int d = 0; d < particles.velocity.components; ++d) {
      const double v = particles.velocity(p, d);
      const double w = v - particles.residual(p, d);
      square += w * w - v * v;
      particles.velocity(p, d) = w;
    }
    change += 0.5 * particles.mass(p) * square;
    if (p % most_summed_rows == 0) change.carry();
  }
  return change;
}

}  // namespace

FilterTally filter_velocity(const Scene& scene, double dt, State& state) {
  if (scene.step.transfer != Transfer::xpic) return {};
  const Region region("filter_velocity");
  FilterTally tally;
  for (const Particles& particles : state.particles)
    if (!particles.rigid) find_residual(particles);
  for (int k = 2; k <= scene.step.xpic_order; ++k) {
    tally.condition_impulse = smooth_residuals(scene, dt, state);
    for (const Particles& particles : state.particles)
      if (!particles.rigid) reduce_residual(particles);
  }
  for (Particles& particles : state.particles)
    if (!particles.rigid) tally.kinetic += take_residual(particles);
  return tally;
}

}  // namespace barreno
