// SPDX-License-Identifier: BSD-3-Clause
#include "step/solve_motion.hpp"

#include "base/gather.hpp"
#include "grid/tiles.hpp"
#include "step/boundary/prescribe_velocities.hpp"
#include "step/dormant/find_dormant_tiles.hpp"
#include "step/nodes/solve_velocity.hpp"
#include "step/particles/relax_pressures.hpp"
#include "step/particles/relax_volumes.hpp"
#include "step/subcycle/tile_steps.hpp"
#include "step/transfer/interpolate_motion.hpp"

#include <algorithm>
#include <array>

namespace barreno {
namespace {

/// A step is taken again at most this often; then the particle policy acts.
constexpr int max_retries = 3;

void add(const GridTally& part, GridTally& sum) {
  sum.kinetic_before += part.kinetic_before;
  sum.kinetic_after += part.kinetic_after;
  sum.force_work += part.force_work;
  sum.condition_work += part.condition_work;
  sum.condition_impulse += part.condition_impulse;
  sum.filter_impulse += part.filter_impulse;
  sum.taken_impulse += part.taken_impulse;
  sum.damped += part.damped;
  sum.damping_impulse += part.damping_impulse;
  sum.absorbed += part.absorbed;
  sum.absorbed_impulse += part.absorbed_impulse;
  sum.contact_work += part.contact_work;
  sum.tangential_work += part.tangential_work;
}

/// Velocities of all fields that forces move, and what they do to each other.
GridTally solve_fields(
    const Scene& scene, const Clock& clock, double damping, State& state, RigidTally& rigid
) {
  const VelocityRule rule(scene, conditions_of_step(state.conditions, clock), damping);
  rigid = solve_contact(
      state.grid,
      state.fields,
      state.rigid_motions,
      {clock.time, damping, rule.grid_share, rule.scales},
      state.contact,
      state.nodes
  );
  const SymmetryPlanes symmetry(scene.conditions, state.grid);
  GridTally tally;
  SpecialTiles special{
      state.contact.shared_tile, state.contact.passes_up, state.dormancy, true, state.subcycling};
  const Stopwatch watch;
  for (std::size_t f = 0; f < state.nodes.size(); ++f) {
    if (state.fields.rigid_body[f] >= 0) continue;
    Nodes& nodes = state.nodes[f];
    GridTally part = solve_velocity(state.grid, rule, special, nodes);
    special.first_field = false;
    mirror_velocities(symmetry, state.grid, rule.grid_share, nodes, part);
    add(part, tally);
  }
  state.effort.tile_seconds += watch.seconds();
  return tally;
}

void relax(
    const std::vector<MaterialSpec>& materials, const State& state, const Particles& particles
) {
  const MaterialSpec& material = materials[static_cast<std::size_t>(particles.material)];
  const double rate = material.volume_relaxation, density = material.density();
  relax_volumes(state.grid, state.dormancy, rate, density, particles);
  // Divided rows are small beside their cells.
  if (particles.split_rule.most > 0 && material.holds_voids())
    relax_pressures(state.grid, state.dormancy, density, particles);
}

/// What the motion of the nodes does to the particles of tiles whose steps end.
/// @return the largest |D| dt of any particle on any rank [-]
double move_with_nodes(const Scene& scene, State& state) {
  find_dormant_tiles(
      scene.step, state.clock, state.grid, state.particles, state.subcycling, state.dormancy
  );
  std::array<double, 1> strain{0.0};
  const Stopwatch watch;
  for (Particles& particles : state.particles) {
    if (particles.rigid) continue;
    const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
    const double of_set =
        interpolate_motion(state.grid, state.dormancy, state.subcycling, nodes, particles);
    strain[0] = std::max(strain[0], of_set);
    relax(scene.materials, state, particles);
  }
  state.effort.node_seconds += watch.seconds();
  max_over_ranks(*state.grid.comm, strain);
  return strain[0];
}

/// A smaller step, or a smaller part of one, with which all tiles then end their steps.
void set_smaller_step(double dt, State& state) {
  if (state.subcycling.on())
    set_part_of_steps(state.grid, dt);
  else
    set_tile_steps(state.grid, dt);
  state.subcycling.ends_all = true;
  state.ledger.retried_steps += 1.0;
}

}  // namespace

void solve_motion(const Scene& scene, double& dt, State& state, StepTally& tally) {
  for (int retry = 0;; ++retry) {
    tally.grid = solve_fields(scene, state.clock, scene.step.damping, state, tally.rigid);
    end_tile_steps(state.grid, state.nodes.front(), state.subcycling);
    const double strain = move_with_nodes(scene, state);
    if (!(strain > scene.step.largest_strain) || retry == max_retries) return;
    dt *= std::max(0.25, 0.8 * scene.step.largest_strain / strain);
    set_smaller_step(dt, state);
  }
}

void move_other_tiles(const Scene& scene, State& state, StepTally& tally) {
  state.subcycling.catches_up = true;
  RigidTally rigid;  // rigid bodies and Subcycles exclude each other
  add(solve_fields(scene, state.clock, scene.step.damping, state, rigid), tally.grid);
  state.subcycling.catches_up = false;
  end_other_tile_steps(state.grid, state.nodes.front(), state.subcycling);
  move_with_nodes(scene, state);
}

void solve_strain(const Scene& scene, const Clock& clock, State& state) {
  RigidTally rigid;
  solve_fields(scene, clock, 0.0, state, rigid);
  const Stopwatch watch;
  for (const Particles& particles : state.particles) {
    if (particles.rigid) continue;
    const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
    Particles asking = particles;  // views of the same rows, but for the motion of the step
    asking.grid_motion = particles.second_pass_motion;
    interpolate_motion(state.grid, state.dormancy, state.subcycling, nodes, asking);
    relax(scene.materials, state, particles);
  }
  state.effort.node_seconds += watch.seconds();
}

}  // namespace barreno
