// SPDX-License-Identifier: BSD-3-Clause
#include "step/tally_step.hpp"

#include "base/launch.hpp"
#include "base/row_sum.hpp"

namespace barreno {

void tally_step(const StepTally& tally, OwnLedger& ledger, std::vector<Reaction>& reactions) {
  const auto& [grid, rigid, applied_work, filter, moved, stress] = tally;
  ledger.mass = moved.mass;
  ledger.momentum = moved.momentum;
  ledger.kinetic = moved.kinetic;
  ledger.boundary_work += grid.condition_work;
  ledger.boundary_work += grid.absorbed;
  ledger.load_impulse += grid.absorbed_impulse;
  ledger.damped += grid.damped;
  ledger.damping_impulse += grid.damping_impulse;
  ledger.condition_impulse += grid.condition_impulse;
  ledger.condition_impulse += grid.taken_impulse;
  ledger.transfer += grid.kinetic_before;
  ledger.transfer -= grid.kinetic_after;
  ledger.transfer += moved.gain;
  ledger.boundary_work += rigid.work;
  for (std::size_t r = 0; r < reactions.size(); ++r) {
    ledger.rigid_impulse -= rigid.reaction[r][1];
    for (std::size_t d = 0; d < 3; ++d) {
      ReproducibleSum& impulse = reactions[r].impulse[d];
      impulse += rigid.reaction[r][d];
      impulse.carry();
    }
  }
  ReproducibleSum lost_along = rigid.tangential_work;
  lost_along -= grid.tangential_work;
  ledger.friction += lost_along;
  ledger.transfer += lost_along;
  ledger.transfer += grid.contact_work;
  ledger.transfer -= rigid.work;
  ledger.elastic += stress.elastic;
  ledger.plastic += stress.plastic;
  ledger.viscous += stress.viscous;
  ledger.explosive += stress.explosive;
  ledger.stress_integration += grid.force_work;
  ledger.stress_integration += grid.damped;
  ledger.stress_integration -= grid.absorbed;
  ledger.stress_integration -= applied_work;
  ledger.stress_integration += stress.stress_work;
  ledger.condition_impulse += filter.condition_impulse;
  ledger.transfer += filter.kinetic;
  carry(ledger);
}

void tally_particle_steps(
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    const Subcycling& subcycling,
    double& particle_steps,
    double& skipped_steps
) {
  for (const Particles& particles : sets)
    if (!particles.rigid) particle_steps += particles.count;
  particle_steps -= dormancy.skipped_rows;
  if (!goes_on(subcycling)) skipped_steps += dormancy.skipped_rows;
}

void tally_step_shares(
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    const Subcycling& subcycling,
    StepShares& shares
) {
  if (!grid.is_refined() && subcycling.most == 1) return;
  const ArrayView<TileFrame> frame = grid.tile_frame;
  for (const Particles& particles : sets) {
    if (particles.rigid) continue;
    const ArrayView<int> begin = particles.tile_begin;
    StepShares of_set;
    launch_reduction(
        "tally_step_shares",
        range(grid.active),
        KOKKOS_LAMBDA(const int t, StepShares& sum) {
          if (dormancy.is_dormant(t) || (subcycling.on() && !subcycling.is_over(t))) return;
          const double rows = begin(t + 1) - begin(t);
          int length = 0;
          while (subcycling.on() && length + 1 < step_lengths && 2 << length <= subcycling.period(t)
          )
            ++length;
          sum.of_level[frame(t).position.level] += rows;
          sum.of_length[length] += rows;
        },
        TallyReducer<StepShares>(of_set)
    );
    add(of_set, shares);
  }
}

}  // namespace barreno
