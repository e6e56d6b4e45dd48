// SPDX-License-Identifier: BSD-3-Clause
// Velocities that conditions set in a step, which tiles have of their own.
#include "step/boundary/prescribe_velocities.hpp"
#include "unit/step/boundary/moving_wall.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::conditions_of;
using testing::moving_wall;

TEST(PrescribeVelocities, VelocitiesAreThoseOfTheMiddlesOfSteps) {
  const NodeConditions of_scene = conditions_of(moving_wall(Mode::plane_strain));
  const NodeConditions now = conditions_of_step(of_scene, {0.5, 0.25, 7});
  const PrescribedVelocities slow = now.over_step(0.5), fast = now.over_step(0.25);
  for (const PrescribedVelocities* v : {&slow, &fast}) {
    EXPECT_EQ(v->before[1][0], 3.0 * 2.0 * 0.375);
    EXPECT_EQ(v->before[1][1], -8.0 * 2.0 * 0.375);
    EXPECT_EQ(v->before[0][0], 0.0);
    EXPECT_EQ(v->after[0][0], 0.0);
  }
  EXPECT_EQ(slow.after[1][1], -8.0 * 2.0 * 0.75);
  EXPECT_EQ(fast.after[1][1], -8.0 * 2.0 * 0.625);
}

TEST(PrescribeVelocities, HomogeneousOnesHoldTheSameNodesAtRest) {
  const NodeConditions of_scene = conditions_of(moving_wall(Mode::plane_strain));
  const NodeConditions zero = homogeneous(conditions_of_step(of_scene, {0.5, 0.25, 7}));
  EXPECT_TRUE(zero.list[1].holds({5, 16, 0}, 0));
  EXPECT_TRUE(zero.list[1].sets[1]);
  const PrescribedVelocities v = zero.over_step(0.5);
  EXPECT_EQ(v.before[1][1], 0.0);
  EXPECT_EQ(v.after[1][1], 0.0);
}

/// A node on the symmetry plane at x = 0 keeps its velocity along it; what stopped it is in the
/// sums.
TEST(PrescribeVelocities, ASymmetryPlaneStopsTheComponentAcrossIt) {
  const NodeConditions now = conditions_of(moving_wall(Mode::plane_strain));
  const double force[2] = {6.0, 8.0};
  NodeVelocity<2> v{{3.0, 2.0}, {5.0, 4.0}};
  ConditionTally tally;
  // It gives no work and no axial momentum.
  EXPECT_FALSE(prescribe_velocities(
      now, now.over_step(0.5), {{0, 5, 0}, 0}, NodeForces<2>{0.5, 2.0, force}, v, tally
  ));
  EXPECT_EQ(v.before[0], 0.0);
  EXPECT_EQ(v.after[0], 0.0);
  EXPECT_EQ(v.before[1], 2.0);
  EXPECT_EQ(v.after[1], 4.0);
  EXPECT_EQ(tally.work, 0.0);
  EXPECT_EQ(tally.axial_impulse, 0.0);
}

/// The wall at y = 16 moves with -8 times a factor that grows by 2 per unit of time: a node on it
/// gets m (v' - v) - f dt from it.
TEST(PrescribeVelocities, AMovingFaceImposesItsOwnAndCountsTheReaction) {
  const NodeConditions now =
      conditions_of_step(conditions_of(moving_wall(Mode::plane_strain)), {0.5, 0.25, 7});
  const double force[2] = {6.0, 8.0};
  NodeVelocity<2> v{{3.0, 2.0}, {5.0, 4.0}};
  ConditionTally tally;
  EXPECT_TRUE(prescribe_velocities(
      now, now.over_step(0.5), {{5, 32, 0}, 1}, NodeForces<2>{0.5, 2.0, force}, v, tally
  ));
  EXPECT_EQ(v.before[1], -6.0);
  EXPECT_EQ(v.after[1], -12.0);
  const double across = 2.0 * (-12.0 + 6.0) - 8.0 * 0.5;
  const double along = 2.0 * (4.5 - 2.25) - 6.0 * 0.5;
  EXPECT_EQ(tally.axial_impulse, across);
  EXPECT_EQ(tally.work, 0.5 * (across * (-6.0 - 12.0) + along * (2.25 + 4.5)));
  EXPECT_EQ(tally.axial_of_start, 2.0 * (-6.0 - 2.0));
}

TEST(PrescribeVelocities, NodesInsideAreLeftAlone) {
  const NodeConditions now = conditions_of(moving_wall(Mode::plane_strain));
  const double force[2] = {6.0, 8.0};
  NodeVelocity<2> v{{3.0, 2.0}, {5.0, 4.0}};
  ConditionTally tally;
  EXPECT_FALSE(prescribe_velocities(
      now, now.over_step(0.5), {{1, 15, 0}, 0}, NodeForces<2>{0.5, 2.0, force}, v, tally
  ));
  EXPECT_EQ(v.before[0], 3.0);
  EXPECT_EQ(v.after[1], 4.0);
}

}  // namespace
}  // namespace barreno
