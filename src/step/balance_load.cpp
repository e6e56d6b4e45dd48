// SPDX-License-Identifier: BSD-3-Clause
#include "step/balance_load.hpp"

#include "base/gather.hpp"
#include "base/region.hpp"
#include "base/rows.hpp"
#include "grid/partition.hpp"
#include "step/place_particles.hpp"

#include <algorithm>
#include <array>

namespace barreno {
namespace {

/// Often enough to follow a wave front, which wakes about a layer of cells in two steps.
constexpr long steps_per_balance = 25;
/// Tiles change hands where that gains this part of the mean: timers are noisy.
constexpr double least_gain = 0.02;
/// A change costs this times what it took: the next step finds afresh what tiles had kept.
constexpr double cost_of_change = 2.0;

void add_over_ranks(const Teuchos::Comm<int>& comm, std::vector<TileCost>& costs) {
  std::vector<double> parts;
  for (const TileCost& cost : costs) parts.insert(parts.end(), {cost.nodes, cost.particles});
  sum_over_ranks(comm, parts);
  for (std::size_t t = 0; t < costs.size(); ++t) costs[t] = {parts[2 * t], parts[2 * t + 1]};
}

/// 1 for a row that the last step advanced, 0 for one of a dormant tile.
int is_awake(const Particles& particles, int p) {
  const unsigned char part = particles.run_part(p / rows_per_run);
  return part == whole_run || (part == part_of_run && particles.left_out(p) == 0) ? 1 : 0;
}

int count_awake(const Particles& particles, Rows in) {
  int count = 0;
  for (int p = in.begin; p < in.end; ++p) count += is_awake(particles, p);
  return count;
}

/// Place of the active tile t among all of the box.
std::size_t box_tile(const Grid& grid, int t) {
  const TilePlace& at = grid.tile_place(t);
  return static_cast<std::size_t>(grid.tile_id(at[0], at[1], at[2]));
}

/// The shortest change so far is what changes cost: others were disturbed.
void change_owners(const Scene& scene, const std::vector<int>& owner, State& state) {
  const Stopwatch watch;
  give_tiles(scene, owner, state);
  std::array<double, 1> took{watch.seconds()};
  max_over_ranks(*state.grid.comm, took);
  double& shortest = state.sharing.change_seconds;
  shortest = shortest > 0.0 ? std::min(shortest, took[0]) : took[0];
}

}  // namespace

std::vector<TileCost> tile_costs(const State& state) {
  const Grid& grid = state.grid;
  double rows = 0.0;
  for (const Particles& particles : state.particles)
    rows += count_awake(particles, {0, particles.count});
  const double per_row = rows > 0.0 ? state.effort.node_seconds / rows : 0.0;
  std::vector<TileCost> costs(grid.owner.size());
  for (int t = 0; t < grid.active; ++t)
    costs[box_tile(grid, t)].nodes += state.effort.tile_seconds / grid.active;
  for (std::size_t set = 0; set < state.particles.size(); ++set) {
    const Particles& particles = state.particles[set];
    std::size_t block = 0;
    for_each_block(particles.count, [&](Rows in) {
      // A block without awake rows is passed over: that takes its time too.
      const int awake = count_awake(particles, in);
      const double seconds =
          state.effort.seconds(set, block++) / (awake > 0 ? awake : in.end - in.begin);
      for (int p = in.begin; p < in.end; ++p) {
        const int is = is_awake(particles, p);
        if (is == 0 && awake > 0) continue;
        const Vector x = vector_of(particles.position, p);
        if (grid.holds(x))
          costs[static_cast<std::size_t>(cell_of(grid, x).tile)] += {is * per_row, seconds};
      }
    });
  }
  add_over_ranks(*grid.comm, costs);
  return costs;
}

void balance_load(const Scene& scene, State& state) {
  const Teuchos::Comm<int>& comm = *state.grid.comm;
  const int ranks = comm.getSize();
  if (ranks == 1 || state.clock.step == 0 || state.clock.step % steps_per_balance != 0) return;
  const Region region("balance_load");
  Effort& effort = state.effort;
  // Ranks wait for each other behind each part (TileCost).
  std::array<double, 2> longest{
      effort.node_seconds + effort.tile_seconds, effort.particle_seconds()};
  std::array<double, 1> mean{(longest[0] + longest[1]) / ranks};
  max_over_ranks(comm, longest);
  sum_over_ranks(comm, mean);
  const double waited = longest[0] + longest[1] - mean[0];
  const double least = least_gain * mean[0];
  Sharing& sharing = state.sharing;
  sharing.waited_seconds += waited;
  if (waited > least && sharing.waited_seconds > cost_of_change * sharing.change_seconds) {
    const std::vector<TileCost> costs = tile_costs(state);
    const std::vector<int> owner = bisect_tiles(state.grid.tiles, costs, ranks, state.grid.owner);
    if (step_cost(state.grid.owner, costs, ranks) - step_cost(owner, costs, ranks) > least)
      change_owners(scene, owner, state);
    sharing.waited_seconds = 0.0;
  }
  effort = {};
}

}  // namespace barreno
