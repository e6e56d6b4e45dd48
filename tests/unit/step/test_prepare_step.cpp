// SPDX-License-Identifier: BSD-3-Clause
// What a step finds: particles in their tiles, a jet's new particles among them, and its size.
#include "step/prepare_step.hpp"
#include "step/stable_step.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

Scene two_blocks() {
  return testing::two_tiles(testing::elastic(1e6, 0.3, 1000.0), 2);
}

TEST(PrepareStep, ParticlesAreInTheirTilesAndTheStepIsThatOfTheFastest) {
  const Scene scene = two_blocks();
  State state = testing::start_alone(scene);
  const StepStart start = prepare_step(scene, 100.0, state);
  const Particles& particles = state.particles[0];
  EXPECT_EQ(start.dt, stable_step_of_rows(scene.step, state.grid, particles, 0));
  EXPECT_EQ(start.interrupt, 0);
  EXPECT_EQ(state.grid.active, 2);
  EXPECT_TRUE(particles.sorted);
  for (int p = 0; p < particles.count; ++p) {
    const int tile = tile_of(state.grid.patch, particles, p);
    EXPECT_EQ(state.grid.tile_frame(tile).position[0], particles.position(p, 0) < 8.0 ? 0 : 1);
  }
}

TEST(PrepareStep, TheStepEndsAtTheNextTime) {
  const Scene scene = two_blocks();
  State state = testing::start_alone(scene);
  EXPECT_EQ(prepare_step(scene, 1e-6, state).dt, 1e-6);
}

/// The slug, one particle, is far faster than the waves of the blocks.
TEST(PrepareStep, ASlugThatIsDueIsLaunchedAndLimitsTheStep) {
  Scene scene = two_blocks();
  scene.jet.present = true;
  scene.jet.launch_position = 6.5;
  scene.jet.direction = -1.0;
  scene.jet.particles_per_cell = 1;
  scene.jet.slugs = {{0.0, 4000.0, 1.0, 1.0, 1000.0}, {1.0, 4000.0, 1.0, 1.0, 1000.0}};
  State state = testing::start_alone(scene);
  const int before = state.particles[0].count;
  const double without = state.stable_step;
  const StepStart start = prepare_step(scene, 100.0, state);
  const Particles& particles = state.particles[0];
  EXPECT_EQ(particles.count, before + 1);
  EXPECT_EQ(state.jet.next_slug, 1U);
  EXPECT_LT(start.dt, 0.1 * without);
  EXPECT_EQ(start.dt, stable_step_of_rows(scene.step, state.grid, particles, 0));
  for (int p = 0; p < particles.count; ++p) EXPECT_TRUE(is_placed(particles.key(p)));
}

}  // namespace
}  // namespace barreno
