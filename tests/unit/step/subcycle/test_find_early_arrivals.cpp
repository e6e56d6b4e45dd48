// SPDX-License-Identifier: BSD-3-Clause
// Particles that come where they cannot be taken in yet.
#include "base/rows.hpp"
#include "step/subcycle/find_early_arrivals.hpp"
#include "step/subcycle/tile_exits.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace barreno {
namespace {

/// Two tiles side by side and none above; the first takes every part of two, the second both.
class EarlyArrivals : public ::testing::Test {
protected:
  EarlyArrivals() : state(testing::in_tiles(scene(), 1.0)) {
    Subcycling& subcycling = state.subcycling;
    subcycling.parts = 2;
    subcycling.period = ArrayView<int>("period", 2);
    subcycling.ends = ArrayView<unsigned char>("ends", 2);
    subcycling.period(0) = 1;
    subcycling.period(1) = 2;
    subcycling.ends(0) = 1;
    subcycling.reach = ArrayView<double>("reach", 2 * told_of_tile);
    foresee(1U << direction(1, 0, 0) | 1U << direction(0, 1, 0));
    Particles& particles = state.particles[0];
    std::fill_n(particles.chunk_part.data(), particles.chunk_part.extent(0), whole_chunk);
  }
  static Scene scene() {
    Scene scene = testing::box_scene(
        Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 16.0}, testing::elastic(1e6, 0.3, 1000.0)
    );
    testing::add_box(scene, "block", {0.0, 0.0}, {16.0, 8.0}, 2);
    return scene;
  }
  /// Directions in which particles may leave the first tile.
  void foresee(unsigned exits) { state.subcycling.reach(told_exits) = exits; }
  /// Of a particle of the first tile, which goes to a place.
  Arrivals arrivals(double x, double y) {
    Particles& particles = state.particles[0];
    const int p = particles.order(0);
    particles.position(p, 0) = x;
    particles.position(p, 1) = y;
    return find_early_arrivals(state.grid, state.particles, state.subcycling);
  }
  int tile_of_first() const {
    const Particles& particles = state.particles[0];
    return index_of(particles.key(particles.order(0))) / state.grid.patch.cells;
  }
  State state;
};

TEST_F(EarlyArrivals, AreThoseInATileWithinItsOwnStep) {
  EXPECT_FALSE(arrivals(7.9, 4.0).early);
  EXPECT_TRUE(arrivals(8.3, 4.0).early);
  state.subcycling.part = 1;  // with which both steps end
  EXPECT_FALSE(arrivals(8.3, 4.0).early);
}

TEST_F(EarlyArrivals, AreThoseWhereNoTileIsButNotThoseThatHaveLeftTheGrid) {
  EXPECT_TRUE(arrivals(4.0, 8.3).early);
  EXPECT_FALSE(arrivals(-0.1, 4.0).early);
  EXPECT_TRUE(arrivals(-0.1, 4.0).strays);
}

/// Whether a tile that nobody was to enter is active depends on what was before.
TEST_F(EarlyArrivals, AreThoseThatNobodyHasForeseen) {
  state.subcycling.part = 1;
  EXPECT_FALSE(arrivals(8.3, 4.0).early);
  foresee(1U << direction(0, 1, 0));
  EXPECT_TRUE(arrivals(8.3, 4.0).early);
  EXPECT_FALSE(arrivals(7.9, 4.0).early);
}

/// Particles are half a cell wide: a quarter of a cell beyond its tile one still gives to nodes of
/// the tile's patch alone.
TEST_F(EarlyArrivals, AreNoneNearTheirTile) {
  const Arrivals near = arrivals(8.2, 4.0);
  EXPECT_FALSE(near.strays);
  EXPECT_FALSE(near.early);
  state.grid.shape = "CPDI";  // whose domains may reach further
  EXPECT_TRUE(arrivals(8.2, 4.0).early);
}

TEST_F(EarlyArrivals, OnlyStraysGetOtherTiles) {
  state.subcycling.period(1) = 1;
  arrivals(8.2, 4.0);
  EXPECT_FALSE(
      place_strays(state.grid, state.subcycling, state.particles, state.ledger).someone_left
  );
  EXPECT_EQ(tile_of_first(), 0);
  EXPECT_TRUE(state.particles[0].sorted);
  arrivals(8.3, 4.0);
  place_strays(state.grid, state.subcycling, state.particles, state.ledger);
  EXPECT_EQ(tile_of_first(), 1);
  EXPECT_FALSE(state.particles[0].sorted);
}

TEST_F(EarlyArrivals, WhatIsLostIsTakenOut) {
  const int count = state.particles[0].count;
  arrivals(-0.1, 4.0);
  place_strays(state.grid, state.subcycling, state.particles, state.ledger);
  EXPECT_EQ(state.particles[0].count, count - 1);
}

}  // namespace
}  // namespace barreno
