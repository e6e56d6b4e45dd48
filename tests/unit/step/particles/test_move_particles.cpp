// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/move_particles.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

TEST(MoveParticles, GoByTheStepOfTheirOwnTile) {
  State state = testing::start_in_tiles(testing::two_tiles(testing::elastic(1.0, 0.25, 1.0)));
  testing::set_frame(state.grid, 0, 1.0, 0.5);
  testing::set_frame(state.grid, 1, 1.0, 0.125);
  Particles& particles = state.particles[0];
  ASSERT_EQ(particles.count, 2);
  for (int p = 0; p < 2; ++p) {
    particles.grid_motion(p, 0) = 2.0;
    particles.grid_motion(p, 1) = -1.0;
  }
  move_particles(state.grid, testing::all_rows_of(particles), particles);
  const int left = testing::row_in(particles, 0), right = testing::row_in(particles, 1);
  EXPECT_EQ(particles.position(left, 0), 3.5 + 0.5 * 2.0);
  EXPECT_EQ(particles.position(left, 1), 3.5 - 0.5);
  EXPECT_EQ(particles.position(right, 0), 11.5 + 0.125 * 2.0);
  EXPECT_EQ(particles.position(right, 1), 3.5 - 0.125);
}

TEST(MoveParticles, RadiusFollowsTheHoopStretch) {
  Scene scene = testing::box_scene(
      Mode::axisymmetric, 1.0, {0.0, 0.0, 0.0}, {8.0, 8.0, 0.0}, testing::elastic(1.0, 0.25, 1.0)
  );
  testing::add_box(scene, "ring", {3.0, 3.0, 0.0}, {4.0, 4.0, 0.0}, 1);
  State state = testing::start_in_tiles(scene);
  testing::set_frame(state.grid, 0, 1.0, 0.5);
  Particles& particles = state.particles[0];
  particles.grid_motion(0, 0) =
      7.0;  // of the ring's centre of mass, which the radius does not take
  particles.grid_motion(0, 1) = 2.0;
  for (const double hoop : {0.01, 1.5}) {  // by the short exponential, and by the general one
    particles.position(0, 0) = 3.5;
    particles.position(0, 1) = 3.5;
    particles.increment(0, 4) = hoop;
    move_particles(state.grid, testing::all_rows_of(particles), particles);
    EXPECT_NEAR(particles.position(0, 0), 3.5 * std::exp(hoop), 1e-14);
    EXPECT_EQ(particles.position(0, 1), 4.5);
  }
}

TEST(MoveParticles, ChunksThatAreDormantStay) {
  State state = testing::start_in_tiles(testing::two_tiles(testing::elastic(1.0, 0.25, 1.0)));
  for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.5);
  Particles& particles = state.particles[0];
  for (int p = 0; p < 2; ++p) particles.grid_motion(p, 0) = 2.0;
  const unsigned char skipped = no_part_of_chunk;
  move_particles(state.grid, {0, 2, &skipped}, particles);
  EXPECT_EQ(particles.position(testing::row_in(particles, 0), 0), 3.5);
  EXPECT_EQ(particles.position(testing::row_in(particles, 1), 0), 11.5);
}

}  // namespace
}  // namespace barreno
