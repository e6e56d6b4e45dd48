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
  const Placement seen = locate_particles(continuum_of(state));
  place_particles(seen, step, continuum_of(state));
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

/// A stone flies past a block of eight tiles: one empty tile is few beside those, two are not.
TEST(PlaceParticles, FewEmptyTilesStayActive) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {64.0, 64.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0}, {32.0, 16.0}, 1);
  testing::add_box(scene, "stone", {40.0, 40.0}, {41.0, 41.0}, 1);
  State state = testing::start_alone(scene);
  Particles& particles = state.particles[0];
  const auto tiles_with_stone_at = [&](double x, double y) {
    int stone = 0;
    for (int p = 0; p < particles.count; ++p)
      if (particles.body(p) == 1) stone = p;
    put(particles, stone, x, y);
    place(state, 1);
    return state.grid.active;
  };
  EXPECT_EQ(tiles_with_stone_at(40.5, 40.5), 9);
  EXPECT_EQ(tiles_with_stone_at(48.5, 48.5), 10);
  EXPECT_EQ(tiles_with_stone_at(56.5, 56.5), 9);
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
  give_parcels(state.grid.owner, 1, continuum_of(state));
  EXPECT_EQ(state.grid.active, 1);
  EXPECT_EQ(state.particles[0].count, 4);
  EXPECT_TRUE(state.particles[0].sorted);
}

}  // namespace
}  // namespace barreno
