// SPDX-License-Identifier: BSD-3-Clause
#include "step/end_part.hpp"

#include "base/gather.hpp"
#include "step/apply_loads.hpp"
#include "step/ranks/place_particles.hpp"
#include "step/solve_motion.hpp"
#include "step/stable_step.hpp"
#include "step/subcycle/find_early_arrivals.hpp"
#include "step/subcycle/tile_steps.hpp"
#include "step/update_sets.hpp"

#include <array>
#include <limits>

namespace barreno {
namespace {

/// A stable step may fall to this share of the parts' length before all tiles meet to choose a
/// smaller one: it rises and falls by a few percent all the time.
constexpr double tolerated_step = 0.9;

/// Also whether particles stray, which a step that goes on has to see to.
bool must_meet(double dt, const StepTally& tally, const StepResult& result, State& state) {
  const Arrivals arrivals = find_early_arrivals(state.grid, state.particles, state.subcycling);
  const bool unstable = tally.stress.stable_step < tolerated_step * dt;
  std::array<double, 2> flags{
      arrivals.early || unstable || result.stopped ? 1.0 : 0.0, arrivals.strays ? 1.0 : 0.0};
  max_over_ranks(*state.grid.comm, flags);
  state.subcycling.strays = flags[1] > 0.0;
  return flags[0] > 0.0;
}

/// Chunks that took part in both updates were counted in both: the totals are taken afresh.
void tally_all_momentum(const State& state, ParticleTally& moved) {
  ParticleTally all;
  for (const Particles& particles : state.particles) add(tally_momentum(particles), all);
  moved.mass = all.mass;
  moved.momentum = all.momentum;
  moved.kinetic = all.kinetic;
}

}  // namespace

void end_or_carry_steps(
    const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result
) {
  if (!must_meet(dt, tally, result, state)) {
    carry_tile_steps(state.grid, state.nodes.front(), state.dormancy, state.subcycling);
    return;
  }
  move_other_tiles(scene, state, tally);
  tally.applied_work += tally_applied_loads(scene.body_force, state);
  update_sets(set_update(scene.materials, scene.step, state.clock.time + dt, state), tally, result);
  agree_on_failure(scene.materials, *state.grid.comm, result);
  tally_all_momentum(state, tally.moved);
  // Chunks that this left as they are had moved before.
  for (Particles& particles : state.particles) particles.settled_chunks = 0;
  state.subcycling.ends_all = true;
}

void prepare_next_part(State& state) {
  constexpr double not_asked = std::numeric_limits<double>::infinity();
  constexpr long between_permutations = 1;
  Grid& grid = state.grid;
  ++state.subcycling.part;
  if (!state.subcycling.strays) return;
  Placement placement = place_strays(grid, state.subcycling, state.particles, state.ledger);
  agree_on_stable_step(*grid.comm, not_asked, placement);
  place_particles(placement, between_permutations, continuum_of(state));
}

}  // namespace barreno
