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
/// Tiles change hands where that gains this part of the mean, and until the next time as much as
/// their last change took: timers are noisy, and a change costs about a step.
constexpr double least_gain = 0.05;

double heaviest_rank(const std::vector<int>& owner, const std::vector<double>& costs, int ranks) {
  std::vector<double> sums(static_cast<std::size_t>(ranks), 0.0);
  for (std::size_t t = 0; t < owner.size(); ++t)
    sums[static_cast<std::size_t>(owner[t])] += costs[t];
  return *std::max_element(sums.begin(), sums.end());
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

}  // namespace

std::vector<double> tile_costs(const State& state) {
  const Grid& grid = state.grid;
  double rows = 0.0;
  for (const Particles& particles : state.particles)
    rows += count_awake(particles, {0, particles.count});
  const double per_row = rows > 0.0 ? state.effort.node_seconds / rows : 0.0;
  std::vector<double> costs(grid.owner.size(), 0.0);
  for (int t = 0; t < grid.active; ++t)
    costs[box_tile(grid, t)] += state.effort.tile_seconds / grid.active;
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
          costs[static_cast<std::size_t>(cell_of(grid, x).tile)] += is * per_row + seconds;
      }
    });
  }
  sum_over_ranks(*grid.comm, costs);
  return costs;
}

void balance_load(const Scene& scene, State& state) {
  const Teuchos::Comm<int>& comm = *state.grid.comm;
  const int ranks = comm.getSize();
  if (ranks == 1 || state.clock.step == 0 || state.clock.step % steps_per_balance != 0) return;
  const Region region("balance_load");
  Effort& effort = state.effort;
  std::array<double, 2> longest{effort.total(), effort.change_seconds};
  std::array<double, 1> sum{effort.total()};
  max_over_ranks(comm, longest);
  sum_over_ranks(comm, sum);
  const double gain = std::max(least_gain * sum[0] / ranks, longest[1]);
  if (longest[0] - sum[0] / ranks > gain) {
    const std::vector<double> costs = tile_costs(state);
    const std::vector<int> owner = bisect_tiles(state.grid.tiles, costs, ranks);
    const double now = heaviest_rank(state.grid.owner, costs, ranks);
    if (now - heaviest_rank(owner, costs, ranks) > gain) {
      const Stopwatch watch;
      give_tiles(scene, owner, state);
      effort.change_seconds = watch.seconds();
    }
  }
  forget(effort);
}

}  // namespace barreno
