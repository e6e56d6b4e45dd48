// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"
#include "step/nodes/sum_halos.hpp"
#include "step/solve_motion.hpp"
#include "step/transfer/project_sets.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// Two particles of mass 4 whose stress along x opens their cells: -V sigma grad S at the nodes.
struct Opening {
  Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  State state = testing::start_in_tiles(scene);
  Particles& particles = state.particles[0];
  StepTally tally;

  explicit Opening(double dt) {
    state.dormancy.on = false;
    for (int p = 0; p < 2; ++p) particles.stress(p, 0) = -8.0;
    set_tile_steps(state.grid, dt);
    project_sets(state.grid, state.particles, state.nodes, state.effort);
    sum_halos(SymmetryPlanes(scene.conditions, state.grid), state.grid, state.nodes);
  }
};

/// Forces of +-4 on nodes of mass 1 give +-4 dt, and D dt = 8 dt^2.
TEST(SolveMotion, ParticlesAreToldOfTheGridsMotion) {
  Opening two(0.125);
  double dt = 0.125;
  solve_motion(two.scene, dt, two.state, two.tally);
  EXPECT_EQ(dt, 0.125);
  for (int p = 0; p < 2; ++p) {
    EXPECT_EQ(two.particles.grid_motion(p, 0), 0.0);
    EXPECT_EQ(two.particles.increment(p, 0), 8.0 * dt * dt);
    EXPECT_EQ(two.particles.velocity(p, 0), 0.0);  // nothing is committed
  }
  EXPECT_EQ(two.tally.grid.kinetic_after, 8.0 * 0.5 * 16.0 * dt * dt);
}

TEST(SolveMotion, AStepThatStrainsTooMuchIsTakenAgain) {
  Opening two(0.5);
  two.scene.step.largest_strain = 0.5;  // 8 dt^2 is 2
  double dt = 0.5;
  solve_motion(two.scene, dt, two.state, two.tally);
  EXPECT_LT(dt, 0.25);
  EXPECT_GE(two.state.ledger.retried_steps, 1.0);
  for (int p = 0; p < 2; ++p) {
    EXPECT_EQ(two.particles.increment(p, 0), 8.0 * dt * dt);
    EXPECT_LE(two.particles.increment(p, 0), 0.5);
  }
  for (int tile = 0; tile < 2; ++tile) EXPECT_EQ(two.state.grid.tile_frame(tile).dt, dt);
}

/// Metal whose voids a step cannot close may be strained by a half, whatever others may.
TEST(SolveMotion, OpenVoidsBearAStrainOfAHalf) {
  Opening two(0.25);
  two.scene.step.largest_strain = 0.1;  // 8 dt^2 is 0.5
  two.particles.history = {"history", dimension::none, 1, {}};
  reserve(two.particles, 4);
  two.particles.void_rule = {0, 0.87, 0.2};
  double dt = 0.25;
  for (int p = 0; p < 2; ++p) two.particles.history(p, 0) = 0.9;
  solve_motion(two.scene, dt, two.state, two.tally);
  EXPECT_EQ(dt, 0.25);
  EXPECT_EQ(two.particles.increment(0, 0), 0.5);
  two.particles.history(1, 0) = 0.8;  // it may close
  solve_motion(two.scene, dt, two.state, two.tally);
  EXPECT_LT(dt, 0.25);
  EXPECT_LE(two.particles.increment(1, 0), 0.1);
}

}  // namespace
}  // namespace barreno
