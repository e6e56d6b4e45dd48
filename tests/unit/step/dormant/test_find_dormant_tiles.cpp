// SPDX-License-Identifier: BSD-3-Clause
// A tile at rest is dormant, its neighbour that moves is not.
#include "base/rows.hpp"
#include "step/dormant/find_dormant_tiles.hpp"
#include "step/ranks/place_particles.hpp"
#include "step/stable_step.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace barreno {
namespace {

/// Two tiles of 8 x 8 cells along x, 128 particles in each.
Scene two_tiles() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0}, {16.0, 4.0}, 2);
  return scene;
}

State placed(const Scene& scene) {
  State state = testing::start_alone(scene);
  const Placement seen = locate_particles(continuum_of(state));
  place_particles(seen, steps_per_permutation, continuum_of(state));
  state.clock.step = 1;
  return state;
}

void find_candidates(State& state) {
  find_dormant_candidates(
      state.grid,
      state.particles,
      state.subcycling,
      state.dormancy,
      state.nodes,
      state.effort,
      state.clock.time
  );
}
/// With nodes of which none moves in the first tile, and some in the second.
void find_tiles(const Scene& scene, State& state, bool second_motionless = false) {
  state.dormancy.motionless(0) = 1;
  state.dormancy.motionless(1) = second_motionless ? 1 : 0;
  find_dormant_tiles(
      scene.step, state.clock, state.grid, state.particles, state.subcycling, state.dormancy
  );
}

TEST(FindDormantCandidates, AVelocityOrAViscousPressureKeepsATileAwake) {
  State state = placed(two_tiles());
  Particles& particles = state.particles[0];
  ASSERT_EQ(state.grid.active, 2);
  ASSERT_TRUE(state.dormancy.on);
  find_candidates(state);
  EXPECT_EQ(state.dormancy.candidate(0), 1);
  EXPECT_EQ(state.dormancy.candidate(1), 1);
  EXPECT_EQ(state.dormancy.rows(1), 128);
  EXPECT_EQ(state.nodes.front().sums_kept(0), 0);  // nothing is known of an earlier step
  particles.velocity(particles.count - 1, 1) = 1e-300;
  find_candidates(state);
  EXPECT_EQ(state.dormancy.candidate(0), 1);
  EXPECT_EQ(state.dormancy.candidate(1), 0);
  particles.velocity(particles.count - 1, 1) = 0.0;
  particles.viscous_pressure(0) = 1e-300;
  find_candidates(state);
  EXPECT_EQ(state.dormancy.candidate(0), 0);
  EXPECT_EQ(state.dormancy.candidate(1), 1);
}

TEST(FindDormantTiles, AreCandidatesWhoseNodesDoNotMove) {
  const Scene scene = two_tiles();
  State state = placed(scene);
  const Particles& particles = state.particles[0];
  find_candidates(state);
  find_tiles(scene, state);
  EXPECT_TRUE(state.dormancy.is_dormant(0));
  EXPECT_FALSE(state.dormancy.is_dormant(1));
  EXPECT_EQ(state.dormancy.skipped_rows, 128);
  for (int p = 0; p < particles.count; ++p) EXPECT_EQ(particles.dormant(p), p < 128 ? 1 : 0);
  for (int chunk = 0; chunk < 4; ++chunk)
    EXPECT_EQ(particles.chunk_part(chunk), chunk < 2 ? no_part_of_chunk : whole_chunk);
  EXPECT_EQ(state.dormancy.stable_step, stable_step_of_rows(scene.step, state.grid, particles, 0));
  // The dormant tile keeps its sums, the other is summed afresh.
  find_candidates(state);
  EXPECT_EQ(state.nodes.front().sums_kept(0), 1);
  EXPECT_EQ(state.nodes.front().sums_kept(1), 0);
}

/// A step that is retried with a smaller size may find a tile dormant that was not.
TEST(FindDormantTiles, FollowTheNodesOfARetriedStep) {
  const Scene scene = two_tiles();
  State state = placed(scene);
  find_candidates(state);
  find_tiles(scene, state);
  find_tiles(scene, state, true);
  EXPECT_TRUE(state.dormancy.is_dormant(1));
  EXPECT_EQ(state.dormancy.skipped_rows, 256);
  find_tiles(scene, state);
  EXPECT_FALSE(state.dormancy.is_dormant(1));
  EXPECT_EQ(state.dormancy.skipped_rows, 128);
}

TEST(FindDormantTiles, NoneIsSkippedInTheFirstStepOrWhereTheDeckSaysSo) {
  const Scene scene = two_tiles();
  State state = placed(scene);
  state.clock.step = 0;
  find_candidates(state);
  find_tiles(scene, state);
  EXPECT_EQ(state.dormancy.skipped_rows, 0);
  EXPECT_EQ(state.dormancy.stable_step, std::numeric_limits<double>::infinity());
  state.clock.step = 1;
  state.dormancy.skip = false;
  find_tiles(scene, state);
  EXPECT_TRUE(state.dormancy.is_dormant(0));
  EXPECT_EQ(state.dormancy.skipped_rows, 0);
  EXPECT_EQ(state.particles[0].chunk_part(0), part_of_chunk);
}

TEST(FindDormantCandidates, ATileAtAPlaneAcrossTheAxisKeepsNoSums) {
  Scene scene = two_tiles();
  testing::add_symmetry(scene, Face::y_lower);
  State state = placed(scene);
  find_candidates(state);
  find_tiles(scene, state);
  find_candidates(state);
  EXPECT_EQ(state.dormancy.candidate(0), 1);
  EXPECT_EQ(state.nodes.front().sums_kept(0), 0);
}

}  // namespace
}  // namespace barreno
