// SPDX-License-Identifier: BSD-3-Clause
// Which cell a particle is in, at its edges too, and what locate_particles sees on the way.
#include "step/continuum.hpp"
#include "step/order/locate_particles.hpp"
#include "step/ranks/place_particles.hpp"
#include "unit/step/order/four_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::four_particles;
using testing::put;

Placement locate(State& state) {
  return locate_particles(continuum_of(state));
}

/// All four tiles active, a particle in each.
State in_four_tiles() {
  State state = testing::start_alone(four_particles());
  Particles& particles = state.particles[0];
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) put(particles, 2 * j + i, 0.5 + 8.0 * i, 0.5 + 8.0 * j);
  locate(state);
  place_particles({false, true}, 1, continuum_of(state));
  return state;
}

TEST(LocateParticles, AParticleOnABorderIsInTheCellAboveIt) {
  State state = in_four_tiles();
  ASSERT_EQ(state.grid.active, 4);
  ASSERT_EQ(state.grid.patch.cells, 64);
  Particles& particles = state.particles[0];
  put(particles, 0, 0.0, 0.0);                         // lower corner of the box
  put(particles, 1, std::nextafter(8.0, 0.0), 3.0);    // last cell of the first tile
  put(particles, 2, 8.0, 3.0);                         // first cell of the second
  put(particles, 3, std::nextafter(16.0, 0.0), 15.5);  // last cell of the box
  const Placement placement = locate(state);
  EXPECT_EQ(index_of(particles.key(0)), 0);
  EXPECT_EQ(index_of(particles.key(1)), 3 * 8 + 7);
  EXPECT_EQ(index_of(particles.key(2)), 64 + 3 * 8);
  EXPECT_EQ(index_of(particles.key(3)), 3 * 64 + 7 * 8 + 7);
  EXPECT_EQ(tile_of(state.grid.patch, particles, 2), 1);
  EXPECT_FALSE(placement.new_tile);
  EXPECT_FALSE(placement.someone_left);
  EXPECT_FALSE(particles.sorted);
}

TEST(LocateParticles, ParticlesThatStayInTheirCellsStaySorted) {
  State state = in_four_tiles();
  put(state.particles[0], 0, 0.75, 0.25);
  locate(state);
  EXPECT_TRUE(state.particles[0].sorted);
}

TEST(LocateParticles, ATileThatIsNotActiveLeavesItsParticleUnplaced) {
  State state = testing::start_alone(four_particles());
  locate(state);
  place_particles({false, true}, 1, continuum_of(state));
  ASSERT_EQ(state.grid.active, 1);
  put(state.particles[0], 2, 9.5, 0.5);
  const Placement placement = locate(state);
  EXPECT_TRUE(placement.new_tile);
  EXPECT_FALSE(placement.someone_left);
  EXPECT_FALSE(is_placed(state.particles[0].key(2)));
  EXPECT_TRUE(is_placed(state.particles[0].key(0)));
}

TEST(LocateParticles, AParticleOnTheUpperFaceHasLeftTheGrid) {
  State state = in_four_tiles();
  put(state.particles[0], 1, 16.0, 3.0);
  locate(state);
  EXPECT_EQ(state.particles[0].count, 3);
  const auto cause = static_cast<std::size_t>(RemovalCause::left_grid);
  EXPECT_EQ(state.ledger.removed[cause].count, 1.0);
}

TEST(LocateParticles, NewcomersAreFoundAmongTheLastRows) {
  State state = in_four_tiles();
  Particles& particles = state.particles[0];
  for (int row = 0; row < 4; ++row) particles.key(row) = CellKey::unplaced;
  locate_newcomers(state.grid, particles, 2);
  EXPECT_FALSE(is_placed(particles.key(1)));
  EXPECT_EQ(index_of(particles.key(2)), 2 * 64);
  EXPECT_EQ(index_of(particles.key(3)), 3 * 64);
}

}  // namespace
}  // namespace barreno
