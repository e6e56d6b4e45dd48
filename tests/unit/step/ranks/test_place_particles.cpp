// SPDX-License-Identifier: BSD-3-Clause
// Tiles become active where particles come and go where none is left.
#include "step/ranks/place_particles.hpp"
#include "unit/step/order/four_particles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::four_particles;
using testing::put;

void place(State& state, long step) {
  const Placement seen = locate_particles(state.grid, state.particles, state.ledger, state.effort);
  place_particles(seen, step, state.grid, state.particles, state.ledger, state.effort);
}

TEST(PlaceParticles, TilesThatHoldParticlesAreActive) {
  State state = testing::start_alone(four_particles());
  Particles& particles = state.particles[0];
  place(state, 1);
  EXPECT_EQ(state.grid.active, 1);
  put(particles, 1, 12.0, 12.0);
  place(state, 1);
  ASSERT_EQ(state.grid.active, 2);
  const TilePosition& at = state.grid.tile_frame(1).position;
  EXPECT_EQ(at[0], 1);
  EXPECT_EQ(at[1], 1);
  EXPECT_EQ(tile_of(state.grid.patch, particles, 1), 1);
  EXPECT_EQ(particles.tile_begin(1) - particles.tile_begin(0), 3);
  EXPECT_EQ(particles.tile_begin(2) - particles.tile_begin(1), 1);
}

TEST(PlaceParticles, RowsAreStoredInOrderOnceInSoManySteps) {
  State state = testing::start_alone(four_particles());
  Particles& particles = state.particles[0];
  place(state, 1);
  put(particles, 0, 5.5, 5.5);  // behind the others
  place(state, steps_per_permutation - 1);
  EXPECT_EQ(particles.id(0), 1);
  put(particles, 0, 6.5, 5.5);
  place(state, steps_per_permutation);
  EXPECT_EQ(particles.id(3), 1);
}

TEST(GiveTiles, OnOneRankChangesNothing) {
  State state = testing::start_alone(four_particles());
  place(state, 1);
  give_parcels(state.grid.owner, 1, state.grid, state.particles, state.ledger, state.effort);
  EXPECT_EQ(state.grid.active, 1);
  EXPECT_EQ(state.particles[0].count, 4);
  EXPECT_TRUE(state.particles[0].sorted);
}

}  // namespace
}  // namespace barreno
