// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/accelerate_particles.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(GridShare, IsThePicFractionAndWhatDampingTakesOfTheRest) {
  StepSpec step;
  EXPECT_EQ(GridShare(step)(0.5), 0.0);
  step.pic_fraction = 0.25;
  EXPECT_EQ(GridShare(step)(0.5), 0.25);
  step.damping = 1.0;
  EXPECT_EQ(GridShare(step)(0.5), 0.25 + 0.75 * 0.5);
  EXPECT_EQ(GridShare(step)(4.0), 1.0);
}

/// v <- (1 - a) (v + dv) + a v_grid, a of the particle's own tile.
TEST(AccelerateParticles, TakeTheShareOfTheirOwnTile) {
  Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  scene.step.pic_fraction = 0.5;
  scene.step.damping = 1.0;
  State state = testing::start_in_tiles(scene);
  testing::set_frame(state.grid, 0, 1.0, 0.5);
  testing::set_frame(state.grid, 1, 1.0, 0.25);
  Particles& particles = state.particles[0];
  for (int p = 0; p < 2; ++p) {
    particles.velocity(p, 0) = 1.0;
    particles.velocity(p, 1) = 8.0;
    const double motion[] = {4.0, 16.0, 2.0, -4.0};  // v, then its increment
    for (int c = 0; c < 4; ++c) particles.grid_motion(p, c) = motion[c];
  }
  const ParticleTally tally =
      accelerate_particles(scene.step, state.grid, testing::all_rows_of(particles), particles);
  double kinetic = 0.0, momentum = 0.0;
  for (int tile = 0; tile < 2; ++tile) {
    const double a = tile == 0 ? 0.75 : 0.625;
    const double x = (1.0 - a) * (1.0 + 2.0) + a * 4.0, y = (1.0 - a) * (8.0 - 4.0) + a * 16.0;
    const int p = testing::row_in(particles, tile);
    EXPECT_EQ(particles.velocity(p, 0), x);
    EXPECT_EQ(particles.velocity(p, 1), y);
    kinetic += 0.5 * 4.0 * (x * x + y * y);
    momentum += 4.0 * y;
  }
  EXPECT_EQ(tally.mass, 8.0);
  EXPECT_EQ(tally.momentum, momentum);
  EXPECT_EQ(tally.kinetic, kinetic);
  EXPECT_EQ(tally.gain, kinetic - 2.0 * 0.5 * 4.0 * 65.0);
}

/// Rows of dormant chunks have a mass, and nothing else.
TEST(AccelerateParticles, ChunksThatAreDormantStay) {
  const Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  State state = testing::start_in_tiles(scene);
  Particles& particles = state.particles[0];
  for (int p = 0; p < 2; ++p) particles.grid_motion(p, 2) = 2.0;
  const unsigned char skipped = no_part_of_chunk;
  const ParticleTally tally =
      accelerate_particles(scene.step, state.grid, {0, 2, &skipped}, particles);
  EXPECT_EQ(tally.mass, 8.0);
  EXPECT_EQ(tally.kinetic, 0.0);
  for (int p = 0; p < 2; ++p) EXPECT_EQ(particles.velocity(p, 0), 0.0);
}

}  // namespace
}  // namespace barreno
