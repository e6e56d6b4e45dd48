// SPDX-License-Identifier: BSD-3-Clause
// A particle that flies into a tile of another rank goes there with all that it has.
#include "base/gather.hpp"
#include "step/ranks/migrate_particles.hpp"
#include "step/ranks/place_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// Two tiles along x with a block of four in each; the last rank owns the second.
State in_two_tiles() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "left", {5.0, 1.0}, {7.0, 3.0}, 1);
  testing::add_box(scene, "right", {10.0, 1.0}, {12.0, 3.0}, 1);
  State state = testing::start(scene);
  const int last = state.grid.comm->getSize() - 1;
  give_parcels({0, last}, 1, continuum_of(state));
  return state;
}

TEST(MigrateParticles, GoToTheRankThatOwnsTheirTile) {
  State state = in_two_tiles();
  const int ranks = state.grid.comm->getSize(), me = state.grid.comm->getRank();
  Particles& particles = state.particles[0];
  const int before = particles.count;
  ASSERT_EQ(before, ranks == 1 ? 8 : 4);
  for (int p = 0; p < particles.count; ++p)
    if (particles.id(p) == 2) {
      particles.position(p, 0) = 8.25;
      particles.velocity(p, 1) = 0.1;
      particles.stress(p, 3) = -1.0 / 3.0;
      particles.body(p) |= debris_bit;
    }
  const Placement seen = locate_particles(continuum_of(state));
  EXPECT_EQ(seen.someone_left, ranks == 2 && me == 0);
  const std::vector<int> first_row = migrate_particles(state.grid, state.particles);
  ASSERT_EQ(first_row.size(), 1U);
  if (ranks == 1) {
    EXPECT_EQ(first_row[0], 8);
    EXPECT_EQ(particles.count, 8);
    return;
  }
  EXPECT_EQ(particles.count, me == 0 ? 3 : 5);
  EXPECT_EQ(first_row[0], me == 0 ? 3 : 4);
  for (int p = 0; p < particles.count; ++p) EXPECT_EQ(particles.id(p) == 2, me == 1 && p == 4);
  if (me == 0) return;
  EXPECT_FALSE(is_placed(particles.key(4)));
  EXPECT_EQ(particles.fault(4), Fault::none);
  EXPECT_EQ(particles.body(4), debris_bit);
  EXPECT_EQ(particles.position(4, 0), 8.25);
  EXPECT_EQ(particles.velocity(4, 1), 0.1);
  EXPECT_EQ(particles.stress(4, 3), -1.0 / 3.0);
  EXPECT_EQ(particles.mass(4), 1000.0);
}

TEST(MigrateParticles, SetsThatNobodyLeavesOrJoinsStaySorted) {
  State state = in_two_tiles();
  locate_particles(continuum_of(state));
  migrate_particles(state.grid, state.particles);
  EXPECT_TRUE(state.particles[0].sorted);
}

}  // namespace
}  // namespace barreno
