// SPDX-License-Identifier: BSD-3-Clause
#include "step/tally_step.hpp"

namespace barreno {
namespace {

void add(const WholeSum& of_step, WholeSum& sum) {
  sum.add(of_step);
  sum.carry();
}

}  // namespace

void tally_step(const Scene& scene, double dt, const StepTally& tally, State& state) {
  const auto& [grid, rigid, applied_work, filter, moved, stress] = tally;
  Ledger& ledger = state.ledger;
  const double share = grid_share(scene.step, dt);
  ledger.mass = moved.mass;
  ledger.momentum = moved.momentum;
  ledger.kinetic = moved.kinetic_after;
  ledger.boundary_work += grid.condition_work + grid.absorbed;
  ledger.load_impulse += grid.absorbed_impulse;
  ledger.damped += grid.damped;
  ledger.damping_impulse += grid.damping_impulse;
  ledger.condition_impulse += grid.condition_impulse + share * grid.filter_impulse;
  ledger.transfer +=
      grid.kinetic_before - moved.kinetic_before + moved.kinetic_after - grid.kinetic_after;
  ledger.boundary_work += rigid.work;
  for (std::size_t r = 0; r < state.reactions.size(); ++r) {
    ledger.rigid_impulse -= rigid.reaction[r][1].value();
    for (std::size_t d = 0; d < 3; ++d) add(rigid.reaction[r][d], state.reactions[r].impulse[d]);
  }
  const double lost_along = rigid.tangential_work - grid.tangential_work;
  ledger.friction += lost_along;
  ledger.transfer -= rigid.work - grid.contact_work - lost_along;
  ledger.elastic += stress.elastic;
  ledger.plastic += stress.plastic;
  ledger.viscous += stress.viscous;
  ledger.stress_integration +=
      grid.force_work + grid.damped - grid.absorbed - applied_work + stress.stress_work;
  ledger.condition_impulse += filter.condition_impulse;
  ledger.transfer += filter.kinetic;
}

void tally_particle_steps(State& state) {
  for (const Particles& particles : state.particles)
    if (!particles.rigid) state.particle_steps += particles.count;
  state.particle_steps -= state.dormancy.skipped;
  state.skipped_steps += state.dormancy.skipped;
}

}  // namespace barreno
