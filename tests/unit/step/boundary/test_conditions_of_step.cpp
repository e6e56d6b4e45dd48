// SPDX-License-Identifier: BSD-3-Clause
// Velocities that conditions set in a step, which tiles have of their own.
#include "step/boundary/conditions_of_step.hpp"
#include "unit/step/boundary/moving_wall.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::conditions_of;
using testing::moving_wall;

TEST(ConditionsOfStep, VelocitiesAreThoseOfTheMiddlesOfSteps) {
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

TEST(ConditionsOfStep, HomogeneousOnesHoldTheSameNodesAtRest) {
  const NodeConditions of_scene = conditions_of(moving_wall(Mode::plane_strain));
  const NodeConditions zero = homogeneous(conditions_of_step(of_scene, {0.5, 0.25, 7}));
  EXPECT_TRUE(zero.list[1].holds({5, 16, 0}, 0));
  EXPECT_TRUE(zero.list[1].sets[1]);
  const PrescribedVelocities v = zero.over_step(0.5);
  EXPECT_EQ(v.before[1][1], 0.0);
  EXPECT_EQ(v.after[1][1], 0.0);
}

}  // namespace
}  // namespace barreno
