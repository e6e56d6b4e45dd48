// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"
#include "step/nodes/sum_halos.hpp"
#include "step/solve_motion.hpp"
#include "step/transfer/filter_velocity.hpp"
#include "step/transfer/project_sets.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// A cell of four particles whose velocities are a mean of (2, 1) and +-1 along x in turns.
struct FourInACell {
  Scene scene;
  State state;
  Particles& particles;

  explicit FourInACell(Transfer transfer)
      : scene(make(transfer)),
        state(testing::start_in_tiles(scene)),
        particles(state.particles[0]) {
    for (int p = 0; p < particles.count; ++p) {
      const bool upper = particles.position(p, 1) > 3.5, right = particles.position(p, 0) > 3.5;
      particles.velocity(p, 0) = 2.0 + (upper == right ? 1.0 : -1.0);
      particles.velocity(p, 1) = 1.0;
    }
    state.dormancy.on = false;
    double dt = 0.01;
    set_tile_steps(state.grid, dt);
    project_sets(state.grid, state.particles, state.nodes, state.effort);
    sum_halos(SymmetryPlanes(scene.conditions, state.grid), state.grid, state.nodes);
    StepTally tally;
    solve_motion(scene, dt, state, tally);
  }
  static Scene make(Transfer transfer) {
    Scene scene = testing::box_scene(
        Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {8.0, 8.0, 0.0}, testing::elastic(1.0, 0.25, 4.0)
    );
    testing::add_box(scene, "four", {3.0, 3.0, 0.0}, {4.0, 4.0, 0.0}, 2);
    scene.step.transfer = transfer;
    return scene;
  }
  FilterTally filter() {
    return filter_velocity(
        {scene.step.transfer == Transfer::xpic ? scene.step.xpic_order : 0,
         VelocityRule(scene, homogeneous(state.conditions), 0.0),
         SymmetryPlanes(scene.conditions, state.grid)},
        state.grid,
        state.fields,
        state.dormancy,
        state.nodes,
        state.particles,
        state.effort
    );
  }
  double kinetic() const {
    double sum = 0.0;
    for (int p = 0; p < particles.count; ++p)
      for (int d = 0; d < 2; ++d)
        sum += 0.5 * particles.mass(p) * particles.velocity(p, d) * particles.velocity(p, d);
    return sum;
  }
  double momentum(int axis) const {
    double sum = 0.0;
    for (int p = 0; p < particles.count; ++p)
      sum += particles.mass(p) * particles.velocity(p, axis);
    return sum;
  }
};

TEST(FilterVelocity, WhatTheGridDoesNotSeeGoesAndMomentumStays) {
  FourInACell four(Transfer::xpic);
  const double before = four.kinetic();
  const FilterTally tally = four.filter();
  EXPECT_NEAR(four.momentum(0), 8.0, 1e-14);
  EXPECT_NEAR(four.momentum(1), 4.0, 1e-14);
  EXPECT_LT(four.kinetic(), before);
  EXPECT_NEAR(tally.kinetic, four.kinetic() - before, 1e-14);
  for (int p = 0; p < four.particles.count; ++p)
    EXPECT_NEAR(four.particles.velocity(p, 1), 1.0, 1e-15);  // the grid holds all of it
}

TEST(FilterVelocity, OtherTransfersKeepTheirVelocities) {
  FourInACell four(Transfer::flip);
  const double before = four.kinetic();
  EXPECT_EQ(four.filter().kinetic, 0.0);
  EXPECT_EQ(four.kinetic(), before);
}

}  // namespace
}  // namespace barreno
