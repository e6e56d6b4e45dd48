// SPDX-License-Identifier: BSD-3-Clause
#include "step/ranks/balance_load.hpp"

#include "base/gather.hpp"
#include "base/region.hpp"
#include "base/rows.hpp"
#include "step/ranks/place_particles.hpp"

#include <algorithm>
#include <array>

namespace barreno {
namespace {

/// Often enough to follow a wave front, which wakes about a layer of cells in two steps.
constexpr long steps_per_balance = 25;
/// Parcels change hands where that gains this part of the mean: timers are noisy.
constexpr double min_gain = 0.02;
/// A change costs this times what it took: the next step finds afresh what tiles remembered.
constexpr double cost_of_change = 2.0;

void add_over_ranks(const Teuchos::Comm<int>& comm, std::vector<ParcelCost>& costs) {
  std::vector<double> parts;
  for (const ParcelCost& cost : costs) parts.insert(parts.end(), {cost.nodes, cost.particles});
  sum_over_ranks(comm, parts);
  for (std::size_t t = 0; t < costs.size(); ++t) costs[t] = {parts[2 * t], parts[2 * t + 1]};
}

/// Seconds of a row: of nodes if it is awake, of particles.
struct RowCost {
  double nodes, awake, dormant;
};

/// Spreads what was measured over the parcels in which the rows are.
struct SpreadCosts {
  ArrayView<unsigned char> part, dormant;
  FieldView position;
  CellLattice lattice;
  double upper[3];
  Parcels parcels;
  ArrayView<double> seconds;  ///< of nodes, then of particles, by parcel

  SpreadCosts(const Grid& grid, const Particles& particles, const ArrayView<double>& by_parcel)
      : part(particles.chunk_part),
        dormant(particles.dormant),
        position(particles.position.values),
        lattice(grid),
        upper{grid.upper[0], grid.upper[1], grid.upper[2]},
        parcels(grid.parcels),
        seconds(by_parcel) {}

  /// 1 for a row that the last step updated, 0 for one that it skipped.
  KOKKOS_INLINE_FUNCTION int is_awake(int p) const {
    const unsigned char of_chunk = part(p / rows_per_chunk);
    return of_chunk == whole_chunk || (of_chunk == part_of_chunk && dormant(p) == 0) ? 1 : 0;
  }
  KOKKOS_INLINE_FUNCTION bool is_inside(int p) const {
    bool inside = true;
    for (int d = 0; d < lattice.dimensions; ++d)
      inside = inside && position(p, d) >= lattice.lower[d] && position(p, d) < upper[d];
    return inside;
  }
  KOKKOS_INLINE_FUNCTION void add(int p, const RowCost& cost) const {
    const bool awake = is_awake(p) != 0;
    if (!is_inside(p)) return;
    const int parcel = parcels.holding(lattice.cell_at(position, p).box_tile);
    if (awake) fetch_add(seconds(2 * parcel), cost.nodes);
    fetch_add(seconds(2 * parcel + 1), awake ? cost.awake : cost.dormant);
  }

  int count_awake(Rows rows) const {
    const SpreadCosts self = *this;
    int count = 0;
    launch_reduction(
        "count_awake",
        range(rows),
        KOKKOS_LAMBDA(const int p, int& sum) { sum += self.is_awake(p); },
        count
    );
    return count;
  }
  void spread(Rows rows, const RowCost& cost) const {
    const SpreadCosts self = *this;
    launch(
        "spread_costs", range(rows), KOKKOS_LAMBDA(const int p) { self.add(p, cost); }
    );
  }
};

/// What cells and nodes have cost, alike for all active tiles.
void spread_tile_seconds(const Grid& grid, double all, const ArrayView<double>& seconds) {
  const ArrayView<TileFrame> frame = grid.tile_frame;
  const BoxTiles box = grid.box;
  const Parcels parcels = grid.parcels;
  const double each = all / grid.active;
  launch(
      "spread_tile_seconds",
      range(grid.active),
      KOKKOS_LAMBDA(const int t) {
        fetch_add(seconds(2 * parcels.holding(box.box_tile(frame(t).position))), each);
      }
  );
}

/// The shortest change so far is what changes cost: others were disturbed.
double shortest_change(const Teuchos::Comm<int>& comm, double took, double shortest) {
  std::array<double, 1> longest{took};
  max_over_ranks(comm, longest);
  return shortest > 0.0 ? std::min(shortest, longest[0]) : longest[0];
}

}  // namespace

std::vector<ParcelCost> parcel_costs(
    const Grid& grid, const std::vector<Particles>& sets, const Effort& effort
) {
  const ArrayView<double> seconds("parcel_costs", 2 * grid.owner.size());
  std::vector<SpreadCosts> spread;
  double rows = 0.0;
  for (const Particles& particles : sets) {
    spread.emplace_back(grid, particles, seconds);
    rows += spread.back().count_awake({0, particles.count});
  }
  const double per_row = rows > 0.0 ? effort.node_seconds / rows : 0.0;
  spread_tile_seconds(grid, effort.tile_seconds, seconds);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::size_t block = 0;
    for_each_block(sets[set].count, [&](Rows in) {
      // A block without awake rows is skipped: that takes its time too.
      const int awake = spread[set].count_awake(in);
      const double each = effort.seconds(set, block++) / (awake > 0 ? awake : in.end - in.begin);
      spread[set].spread(in, {per_row, each, awake > 0 ? 0.0 : each});
    });
  }
  const auto found = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), seconds);
  std::vector<ParcelCost> costs(grid.owner.size());
  for (std::size_t t = 0; t < costs.size(); ++t) costs[t] = {found(2 * t), found(2 * t + 1)};
  add_over_ranks(*grid.comm, costs);
  return costs;
}

void balance_load(const Clock& clock, const Continuum& continuum, LoadBalance& sharing) {
  const Grid& grid = continuum.grid;
  Effort& effort = continuum.effort;
  const Teuchos::Comm<int>& comm = *grid.comm;
  const int ranks = comm.getSize();
  if (ranks == 1 || clock.step == 0 || clock.step % steps_per_balance != 0) return;
  const Region region("balance_load");
  // Ranks wait for each other behind each part (ParcelCost).
  std::array<double, 2> longest{
      effort.node_seconds + effort.tile_seconds, effort.particle_seconds()};
  std::array<double, 1> mean{(longest[0] + longest[1]) / ranks};
  max_over_ranks(comm, longest);
  sum_over_ranks(comm, mean);
  const double waited = longest[0] + longest[1] - mean[0];
  const double least = min_gain * mean[0];
  sharing.waited_seconds += waited;
  if (waited > least && sharing.waited_seconds > cost_of_change * sharing.change_seconds) {
    const std::vector<ParcelCost> costs = parcel_costs(grid, continuum.sets, effort);
    const std::vector<int> owner = bisect_parcels(grid.parcels.along, costs, ranks, grid.owner);
    if (step_cost(grid.owner, costs, ranks) - step_cost(owner, costs, ranks) > least) {
      const Stopwatch watch;
      give_parcels(owner, clock.step, continuum);
      sharing.change_seconds = shortest_change(comm, watch.seconds(), sharing.change_seconds);
    }
    sharing.waited_seconds = 0.0;
  }
  effort = {};
}

}  // namespace barreno
