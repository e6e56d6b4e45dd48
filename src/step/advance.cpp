// SPDX-License-Identifier: BSD-3-Clause
#include "step/advance.hpp"

#include "base/region.hpp"
#include "grid/tiles.hpp"
#include "pore_flow/drain_pore_fluid.hpp"
#include "step/apply_loads.hpp"
#include "step/cell_step.hpp"
#include "step/contact/detect_contact_nodes.hpp"
#include "step/contact/fit_surface_normals.hpp"
#include "step/contact/refine_surface_normals.hpp"
#include "step/dormant/find_dormant_tiles.hpp"
#include "step/end_part.hpp"
#include "step/nodes/sum_halos.hpp"
#include "step/prepare_step.hpp"
#include "step/solve_motion.hpp"
#include "step/stable_step.hpp"
#include "step/subcycle/tile_steps.hpp"
#include "step/tally_step.hpp"
#include "step/transfer/filter_velocity.hpp"
#include "step/transfer/gather_affine.hpp"
#include "step/transfer/project_sets.hpp"
#include "step/update_sets.hpp"

#include <algorithm>

namespace barreno {
namespace {

/// Where velocity fields meet: usually there is one. docs/method.md 6
void detect_contact(const SymmetryPlanes& symmetry, State& state) {
  const ContactBodies bodies{state.grid, state.fields, state.particles, symmetry};
  detect_contact_nodes(state.grid, state.fields, state.particles, state.nodes, state.contact);
  fit_surface_normals(bodies, state.contact);
  refine_surface_normals(bodies, state.contact);  // and the gaps
}

/// The powers of XPIC; none for other transfers.
FilterRule filter_rule(const Scene& scene, const State& state) {
  return {
      scene.step.transfer == Transfer::xpic ? scene.step.xpic_order : 0,
      VelocityRule(scene, homogeneous(state.conditions), 0.0),
      SymmetryPlanes(scene.conditions, state.grid)};
}

/// From forces to the velocity of the step, which every order of the step has in the middle.
void solve_momentum_balance(const Scene& scene, double& dt, State& state, StepTally& tally) {
  const SymmetryPlanes symmetry(scene.conditions, state.grid);
  start_tile_steps(state.grid, dt, state.subcycling);
  find_dormant_candidates(
      state.grid,
      state.particles,
      state.subcycling,
      state.dormancy,
      state.nodes,
      state.effort,
      state.clock.time + (state.subcycling.most + 1) * dt
  );  // which may keep their sums
  project_sets(state.grid, state.particles, state.nodes, state.effort);  // m, p, f  (2.1-2.3)
  apply_loads(forces_of(scene), state);          // pressures, body force    (2.4)
  sum_halos(symmetry, state.grid, state.nodes);  // symmetry planes, other ranks
  detect_contact(symmetry, state);               // contact
  solve_motion(scene, dt, state, tally);         // v', conditions; v, dt L (2.5-2.6)
  tally.applied_work = tally_applied_loads(scene.body_force, state);  // before F and x move on
  state.ledger.remembered = gather_affine(state.grid, state.nodes, state.particles);  // APIC
  tally.filter = filter_velocity(                                                     // XPIC (2.10)
      filter_rule(scene, state),
      state.grid,
      state.fields,
      state.dormancy,
      state.nodes,
      state.particles,
      state.effort
  );
}

/// Strain from the velocities that particles now have, of a step from `clock` on. (2.11)
void strain_again(const Scene& scene, const Clock& clock, double dt, State& state) {
  set_tile_steps(state.grid, dt);
  project_sets(state.grid, state.particles, state.nodes, state.effort);
  drop_forces(state.grid, state.nodes);
  const SymmetryPlanes symmetry(scene.conditions, state.grid);
  sum_halos(symmetry, state.grid, state.nodes);
  detect_contact(symmetry, state);
  solve_strain(scene, clock, state);
}

/// Stress last (USL): strain from v'.
void step_usl(const Scene& scene, double& dt, State& state, StepTally& tally, StepResult& result) {
  solve_momentum_balance(scene, dt, state, tally);
  update_sets(
      set_update(scene.materials, scene.step, state.clock.time + dt, state), tally, result
  );  // v, x, F, sigma (2.7-2.9)
}

/// Modified stress last (MUSL): strain from the new velocities of particles, weights as before.
void step_musl(const Scene& scene, double& dt, State& state, StepTally& tally, StepResult& result) {
  solve_momentum_balance(scene, dt, state, tally);
  const double end = state.clock.time + dt;
  accelerate_sets(set_update(scene.materials, scene.step, end, state), tally);
  strain_again(scene, state.clock, dt, state);
  move_and_strain_sets(set_update(scene.materials, scene.step, end, state), tally, result);
}

/// Stress first (USF): the strain of the last step is found where the particles have come to. The
/// first step has none behind it.
void step_usf(const Scene& scene, double& dt, State& state, StepTally& tally, StepResult& result) {
  const Clock& clock = state.clock;
  if (clock.dt > 0.0) {
    strain_again(scene, {clock.time - clock.dt, clock.dt, clock.step - 1}, clock.dt, state);
    strain_sets(set_update(scene.materials, scene.step, clock.time, state), tally, result);
  } else {
    tally.stress.stable_step = state.stable_step;
  }
  solve_momentum_balance(scene, dt, state, tally);
  accelerate_and_move_sets(
      set_update(scene.materials, scene.step, state.clock.time + dt, state), tally
  );
}

/// What is left of a step after its parts is their rounding: a step of that length would double a
/// row of the history.
double end_of_part(double time, double dt, double next_time) {
  constexpr double round_off = 1e-9;  // of a part
  return next_time - time <= (1.0 + round_off) * dt ? next_time : time + dt;
}

/// All of a step, or one of the parts of Subcycling, in which nodes move and the particles of
/// tiles that end their own steps.
void take_part(const Scene& scene, double next_time, double& dt, State& state, StepResult& result) {
  StepTally tally;
  const auto step = scene.step.order == Order::stress_last            ? step_usl
                    : scene.step.order == Order::modified_stress_last ? step_musl
                                                                      : step_usf;
  step(scene, dt, state, tally, result);
  Clock& clock = state.clock;
  move_rigid_sets(state.rigid_motions, clock.time, state.grid, state.particles, tally);
  agree_on_failure(scene.materials, *state.grid.comm, result);
  if (goes_on(state.subcycling)) end_or_carry_steps(scene, dt, state, tally, result);
  tally_step(tally, state.ledger, state.reactions);  // energy and momentum, term by term
  tally_particle_steps(
      state.particles, state.dormancy, state.subcycling, state.particle_steps, state.skipped_steps
  );
  tally_step_shares(
      state.grid, state.particles, state.dormancy, state.subcycling, state.step_shares
  );
  state.stable_step = std::min(tally.stress.stable_step, state.dormancy.stable_step);
  clock.time = end_of_part(clock.time, dt, next_time);
  clock.dt = dt;
}

/// What sets whose rows decide by cells allow.
void limit_by_cells(const StepSpec& spec, State& state) {
  for (Particles& particles : state.particles) {
    if (!decides_by_cells(particles)) continue;
    particles.stable_step = stable_step_of_cells(spec, state.grid, particles);
    state.stable_step = std::min(state.stable_step, particles.stable_step);
  }
}

}  // namespace

StepResult advance(const Scene& scene, double next_time, State& state) {
  const Region region("advance");
  state.resumed_tile_steps.clear();
  const StepStart start = prepare_step(scene, next_time, state);  // cells, ranks, jet; dt
  StepResult result;
  result.interrupt = start.interrupt;
  double dt = start.dt;
  state.clock.begin = state.clock.time;
  take_part(scene, next_time, dt, state, result);
  while (goes_on(state.subcycling)) {
    prepare_next_part(state);
    take_part(scene, next_time, dt, state, result);
  }
  limit_by_cells(scene.step, state);
  ++state.clock.step;
  const bool repeated = dt < start.dt;
  count_step(
      repeated ? row_of(OtherLimit::strain, static_cast<int>(scene.materials.size()))
               : start.set_by,
      state.clock.time - state.clock.begin,
      dt,
      state.step_limits
  );
  result.not_drained =
      drain_pore_fluid(porous_medium(scene, state), dt, state.pore_flow, state.ledger);  // (7)
  return result;
}

}  // namespace barreno
