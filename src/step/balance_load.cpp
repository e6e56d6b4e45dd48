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

constexpr long steps_per_balance = 100;
/// Longest rank over mean from which sharing anew is thought of, and what it must gain: moving
/// particles costs about a step, tiles are not infinitely small, and timers are noisy.
constexpr double tolerated_imbalance = 1.03;
constexpr double least_gain = 0.02;

double heaviest_rank(const std::vector<int>& owner, const std::vector<double>& costs, int ranks) {
  std::vector<double> sums(static_cast<std::size_t>(ranks), 0.0);
  for (std::size_t t = 0; t < owner.size(); ++t)
    sums[static_cast<std::size_t>(owner[t])] += costs[t];
  return *std::max_element(sums.begin(), sums.end());
}

/// 1 for a row that the last step advanced, 0 for one of a dormant tile, which costs next to
/// nothing.
int is_awake(const Particles& particles, int p) {
  const unsigned char part = particles.run_part(p / rows_per_run);
  return part == whole_run || (part == part_of_run && particles.left_out(p) == 0) ? 1 : 0;
}

int count_awake(const Particles& particles, Rows in) {
  int count = 0;
  for (int p = in.begin; p < in.end; ++p) count += is_awake(particles, p);
  return count;
}

}  // namespace

std::vector<double> tile_costs(const State& state) {
  const Grid& grid = state.grid;
  double rows = 0.0;
  for (const Particles& particles : state.particles)
    rows += count_awake(particles, {0, particles.count});
  const double everywhere = rows > 0.0 ? state.effort.node_seconds / rows : 0.0;
  std::vector<double> costs(grid.owner.size(), 0.0);
  for (std::size_t set = 0; set < state.particles.size(); ++set) {
    const Particles& particles = state.particles[set];
    std::size_t block = 0;
    for_each_block(particles.count, [&](Rows in) {
      const double seconds =
          state.effort.seconds(set, block++) / std::max(count_awake(particles, in), 1);
      for (int p = in.begin; p < in.end; ++p) {
        if (is_awake(particles, p) == 0) continue;
        const Vector x = vector_of(particles.position, p);
        if (grid.holds(x))
          costs[static_cast<std::size_t>(cell_of(grid, x).tile)] += everywhere + seconds;
      }
    });
  }
  sum_over_ranks(*grid.comm, costs);
  return costs;
}

void balance_load(const Scene& scene, State& state) {
  const int ranks = state.grid.comm->getSize();
  if (ranks == 1 || state.clock.step == 0 || state.clock.step % steps_per_balance != 0) return;
  const Region region("balance_load");
  const double own = state.effort.total();
  std::array<double, 1> longest{own};
  std::array<double, 1> sum{own};
  max_over_ranks(*state.grid.comm, longest);
  sum_over_ranks(*state.grid.comm, sum);
  if (longest[0] > tolerated_imbalance * sum[0] / ranks) {
    const std::vector<double> costs = tile_costs(state);
    const std::vector<int> owner = bisect_tiles(state.grid.tiles, costs, ranks);
    const double now = heaviest_rank(state.grid.owner, costs, ranks);
    if (heaviest_rank(owner, costs, ranks) < (1.0 - least_gain) * now)
      give_tiles(scene, owner, state);
  }
  state.effort = {};
}

}  // namespace barreno
