// SPDX-License-Identifier: BSD-3-Clause
#include "step/prepare_step.hpp"

#include "step/jet/launch_jet.hpp"
#include "step/loads/load_pressures.hpp"
#include "step/nodes/find_node_periods.hpp"
#include "step/order/split_particles.hpp"
#include "step/ranks/balance_load.hpp"
#include "step/ranks/place_particles.hpp"
#include "step/stable_step.hpp"
#include "step/subcycle/plan_subcycles.hpp"
#include "step/subcycle/reached_tiles.hpp"
#include "step/transfer/start_affine.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// The jet's slugs whose time has come, and the step that they allow.
void launch_slugs(const Scene& scene, State& state) {
  if (!scene.jet.present) return;
  const auto material = static_cast<std::size_t>(scene.jet.material);
  Particles& particles = state.particles[material];
  const int first_row = launch_jet(
      scene.jet,
      scene.materials[material],
      state.grid,
      state.clock.time,
      state.jet,
      particles,
      state.ledger
  );
  particles.stable_step = std::min(
      particles.stable_step, stable_step_of_rows(scene.step, state.grid, particles, first_row)
  );
  state.stable_step = std::min(state.stable_step, particles.stable_step);
}

/// Where a step ends at the latest: where no particle bounds it, as before the first slug of a jet
/// alone, that is the launch of the next slug, which would else be skipped. A step of
/// t - time may end a rounding before t, hence the few bits behind it.
double end_of_step(const JetSpec& jet, const State& state, double stable, double next_time) {
  const std::size_t slug = state.jet.next_slug;
  if (std::isfinite(stable) || !jet.present || slug >= jet.slugs.size()) return next_time;
  return std::min(next_time, jet.slugs[slug].time * (1.0 + 1e-15));
}

/// What set the step, as a row of StepLimits.
int row_of_rule(StepRule rule, int set, bool by_fluids, std::size_t sets) {
  const auto materials = static_cast<int>(sets);
  if (rule == StepRule::growth) return row_of(OtherLimit::growth, materials);
  if (rule == StepRule::largest) return row_of(OtherLimit::largest, materials);
  if (rule == StepRule::event) return row_of(OtherLimit::output, materials);
  if (by_fluids) return row_of(OtherLimit::cavity, materials);
  return set >= 0 ? set : row_of(OtherLimit::tiles_at_rest, materials);
}

/// How the step is divided, with all tiles active that particles may enter before it is over.
void plan_parts(const Scene& scene, double dt, double left, State& state) {
  const auto reaches_others = [&] {
    return plan_subcycles(
        scene.step, state.grid, state.particles, state.dormancy, dt, left, state.subcycling
    );
  };
  while (reaches_others())
    activate_reached_tiles(
        reached_tiles(state.grid, state.subcycling), state.clock.step, continuum_of(state)
    );
  find_node_periods(
      SymmetryPlanes(scene.conditions, state.grid),
      state.conditions,
      state.grid,
      state.particles,
      state.subcycling
  );
}

}  // namespace

StepStart prepare_step(const Scene& scene, double next_time, State& state) {
  const Clock& clock = state.clock;
  Grid& grid = state.grid;
  std::vector<Particles>& sets = state.particles;
  const Continuum continuum = continuum_of(state);
  balance_load(clock, continuum, state.sharing);           // tiles to ranks by cost
  launch_slugs(scene, state);                              // whose time has come
  for (Particles& set : sets) split_particles(grid, set);  // where they are wide
  if (state.subcycling.on()) forget_keys(sets);            // parts of the last step kept some
  Placement placement = locate_particles(continuum);       // cells; lost are tallied
  int set = -1;                                            // whose particles allow no more
  const double stable =
      agree_on_stable_step(*grid.comm, sets, state.stable_step, state.agreed, placement, set);
  const double with_fluids = stable_step_with_fluids(state.cavities, grid.smallest_cell(), stable);
  const double end = end_of_step(scene.jet, state, stable, next_time);
  const NextStep next = next_step(scene.step, clock, end, with_fluids);
  place_particles(placement, clock.step, continuum);  // ranks, tiles, order
  if (clock.step == 0) start_affine(grid, sets);      // APIC
  // The first step settles what materials make of their initial states: together.
  plan_parts(scene, next.dt, clock.step == 0 ? 0.0 : next_time - clock.time, state);
  const bool by_fluids = with_fluids < stable;
  return {next.dt, placement.interrupt, row_of_rule(next.set_by, set, by_fluids, sets.size())};
}

}  // namespace barreno
