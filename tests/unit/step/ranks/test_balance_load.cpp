// SPDX-License-Identifier: BSD-3-Clause
// What tiles have cost, from what was measured, and that tiles change hands where that gains.
#include "base/gather.hpp"
#include "base/rows.hpp"
#include "step/ranks/balance_load.hpp"
#include "step/ranks/place_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace barreno {
namespace {

/// Four tiles along x with a block of four particles in each; rank 0 owns all.
State in_four_tiles() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {32.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  for (const double x : {1.0, 9.0, 17.0, 25.0})
    testing::add_box(scene, "block", {x, 1.0}, {x + 2.0, 3.0}, 1);
  State state = testing::start(scene);
  give_parcels({0, 0, 0, 0}, 1, continuum_of(state));
  state.effort = {};
  return state;
}

/// Rank 0 has measured a second of each kind for every tile.
void measure(State& state) {
  if (state.grid.comm->getRank() != 0) return;
  state.effort.tile_seconds = 4.0;
  state.effort.node_seconds = 4.0;
  state.effort.add(0, 0, 4.0);
}

TEST(ParcelCosts, AreSharedByTheRowsInThem) {
  State state = in_four_tiles();
  measure(state);
  for (const ParcelCost& cost : parcel_costs(state.grid, state.particles, state.effort)) {
    EXPECT_DOUBLE_EQ(cost.nodes, 2.0);
    EXPECT_DOUBLE_EQ(cost.particles, 1.0);
  }
}

/// Rows that the step has skipped take nothing of what awake ones cost.
TEST(ParcelCosts, DormantRowsCostNothing) {
  State state = in_four_tiles();
  measure(state);
  Particles& particles = state.particles[0];
  if (particles.count > 0) particles.chunk_part(0) = part_of_chunk;
  for (int p = 0; p < particles.count; ++p)
    particles.dormant(p) = tile_of(state.grid.patch, particles, p) == 0 ? 1 : 0;
  const std::vector<ParcelCost> costs = parcel_costs(state.grid, state.particles, state.effort);
  EXPECT_DOUBLE_EQ(costs[0].nodes, 1.0);
  EXPECT_EQ(costs[0].particles, 0.0);
  for (std::size_t t = 1; t < 4; ++t) {
    EXPECT_DOUBLE_EQ(costs[t].nodes, 1.0 + 4.0 / 3.0);
    EXPECT_DOUBLE_EQ(costs[t].particles, 4.0 / 3.0);
  }
}

TEST(BalanceLoad, ARankThatWaitedGetsTiles) {
  State state = in_four_tiles();
  const int ranks = state.grid.comm->getSize();
  measure(state);
  const auto balance = [&](long step) {
    balance_load({0.0, 0.0, step}, continuum_of(state), state.sharing);
  };
  balance(24);  // not yet
  EXPECT_TRUE(std::all_of(state.grid.owner.begin(), state.grid.owner.end(), [](int owner) {
    return owner == 0;
  }));
  balance(25);
  for (int rank = 0; rank < ranks; ++rank)
    EXPECT_EQ(std::count(state.grid.owner.begin(), state.grid.owner.end(), rank), 4 / ranks);
  EXPECT_EQ(state.grid.active, 4 / ranks);
  EXPECT_EQ(state.particles[0].count, 16 / ranks);
  if (ranks > 1) EXPECT_GT(state.sharing.change_seconds, 0.0);
}

}  // namespace
}  // namespace barreno
