// SPDX-License-Identifier: BSD-3-Clause
#include "step/advance.hpp"

#include "base/region.hpp"
#include "pore_flow/drain_pore_fluid.hpp"
#include "step/balance_load.hpp"
#include "step/filter_velocity.hpp"
#include "step/find_dormant_tiles.hpp"
#include "step/find_motion.hpp"
#include "step/fit_normals.hpp"
#include "step/gather_affine.hpp"
#include "step/launch_jet.hpp"
#include "step/project_body_force.hpp"
#include "step/project_loads.hpp"
#include "step/project_sets.hpp"
#include "step/release_torn_faces.hpp"
#include "step/seek_normals.hpp"
#include "step/share_nodes.hpp"
#include "step/stable_step.hpp"
#include "step/start_affine.hpp"
#include "step/surface_pressures.hpp"
#include "step/tally_step.hpp"
#include "step/update_sets.hpp"

#include <algorithm>

namespace barreno {
namespace {

/// Where velocity fields meet: usually there is one. docs/method.md 6
void meet_fields(const Scene& scene, State& state) {
  share_nodes(state);
  fit_normals(scene, state);   // of the surfaces between them
  seek_normals(scene, state);  // turned to the widest gap, and the gap
}

/// From forces to the velocity of the step, which every order of the step has in the middle.
void solve_motion(const Scene& scene, double& dt, State& state, StepTally& tally) {
  find_resting_tiles(scene, state);  // which may keep their sums
  project_sets(scene, state);        // m, p, f                    (2.1-2.3)
  release_torn_faces(scene, state);  // debris has none
  project_loads(scene, state);       // pressure on faces          (2.4)
  project_surface_pressures(scene, state);
  project_body_force(scene, state);                    // force per mass
  join_nodes(scene, state);                            // symmetry planes, other ranks
  meet_fields(scene, state);                           // contact
  find_motion(scene, dt, state, tally);                // v', conditions; v, dt L (2.5-2.6)
  tally.applied_work = tally_loads(scene, dt, state);  // before F and x move on
  tally.applied_work += tally_surface_pressures(scene, dt, state);
  tally.applied_work += tally_body_force(scene, dt, state);
  gather_affine(scene, state);                       // APIC   (2.12)
  tally.filter = filter_velocity(scene, dt, state);  // XPIC   (2.10)
}

/// Strain from the velocities that particles now have, of a step from `clock` on. (2.11)
void strain_again(const Scene& scene, const Clock& clock, double dt, State& state) {
  project_sets(scene, state);
  drop_forces(state);
  join_nodes(scene, state);
  meet_fields(scene, state);
  find_strain(scene, clock, dt, state);
}

/// Stress last (USL): strain from v'.
void step_usl(const Scene& scene, double& dt, State& state, StepTally& tally, StepResult& result) {
  solve_motion(scene, dt, state, tally);
  update_sets(scene, dt, state, tally, result);  // v, x, F, sigma (2.7-2.9)
}

/// Modified stress last (MUSL): strain from the new velocities of particles, weights as before.
void step_musl(const Scene& scene, double& dt, State& state, StepTally& tally, StepResult& result) {
  solve_motion(scene, dt, state, tally);
  accelerate_sets(scene, dt, state, tally);
  strain_again(scene, state.clock, dt, state);
  move_and_strain_sets(scene, dt, state, tally, result);
}

/// Stress first (USF): the strain of the last step is found where the particles have come to. The
/// first step has none behind it.
void step_usf(const Scene& scene, double& dt, State& state, StepTally& tally, StepResult& result) {
  const Clock& clock = state.clock;
  if (clock.dt > 0.0) {
    strain_again(scene, {clock.time - clock.dt, clock.dt, clock.step - 1}, clock.dt, state);
    strain_sets(scene, clock.dt, state, tally, result);
  } else {
    tally.stress.stable_step = state.stable_step;
  }
  solve_motion(scene, dt, state, tally);
  accelerate_and_move_sets(scene, dt, state, tally);
}

}  // namespace

StepResult advance(const Scene& scene, double next_time, State& state) {
  const Region region("advance");
  balance_load(scene, state);                            // tiles to ranks by measured cost
  launch_jet(scene, state);                              // slugs whose time has come
  Placement placement = locate_particles(scene, state);  // cell of each; the lost are tallied
  double dt = agree_on_step(scene, next_time, placement, state);  // of all ranks
  place_particles(scene, placement, state);                       // ranks, tiles, order
  start_affine(scene, state);                                     // APIC, first step

  StepTally tally;
  StepResult result;
  result.interrupt = placement.interrupt;
  const auto step = scene.step.order == Order::stress_last            ? step_usl
                    : scene.step.order == Order::modified_stress_last ? step_musl
                                                                      : step_usf;
  step(scene, dt, state, tally, result);
  move_rigid_sets(scene, dt, state, tally);
  tally_step(tally, state);  // energy and momentum, term by term
  agree_on_failure(scene, state, result);

  tally_particle_steps(state);  // advanced, and left as they were
  state.stable_step = std::min(tally.stress.stable_step, state.dormancy.stable_step);
  const double left = next_time - state.clock.time;
  state.clock = {dt >= left ? next_time : state.clock.time + dt, dt, state.clock.step + 1};
  result.not_drained = drain_pore_fluid(scene, dt, state);  // (7)
  return result;
}

}  // namespace barreno
