// SPDX-License-Identifier: BSD-3-Clause
// Conditions of the faces of the grid: the nodes that they hold, and velocities of each tile's
// step.
#include "scene/time_tables.hpp"
#include "state/node_conditions.hpp"
#include "step/boundary/node_conditions.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

Scene moving_wall(Mode mode) {
  Scene scene = testing::box_scene(
      mode, 1.0, {0.0, 0.0, 0.0}, {8.0, 16.0, 0.0}, testing::elastic(1e9, 0.3, 1e3)
  );
  testing::add_symmetry(scene, Face::x_lower);
  ConditionSpec wall{"wall", Face::y_upper, ConditionKind::prescribed_velocity, {3.0, -8.0, 0.0}};
  wall.factor = {{0.0, 1.0}, {0.0, 2.0}};
  scene.conditions.push_back(wall);
  return scene;
}

NodeConditions conditions_of(const Scene& scene) {
  return make_node_conditions(scene.conditions, testing::start_alone(scene).grid);
}

TEST(NodeConditions, HoldTheNodesAtAndBehindTheirFaces) {
  const NodeConditions plane = conditions_of(moving_wall(Mode::plane_strain));
  ASSERT_EQ(plane.count, 2);
  EXPECT_TRUE(plane.list[0].holds({0, 5, 0}));
  EXPECT_TRUE(plane.list[0].holds({-1, 5, 0}));
  EXPECT_FALSE(plane.list[0].holds({1, 5, 0}));
  EXPECT_TRUE(plane.list[0].sets[0]);
  EXPECT_FALSE(plane.list[0].sets[1]);
  EXPECT_TRUE(plane.list[1].holds({5, 16, 0}));
  EXPECT_FALSE(plane.list[1].holds({5, 15, 0}));
  EXPECT_TRUE(plane.list[1].sets[0]);
  EXPECT_TRUE(plane.list[1].sets[1]);
  // The axis of revolution needs nobody to ask for it.
  const NodeConditions round = conditions_of(moving_wall(Mode::axisymmetric));
  ASSERT_EQ(round.count, 3);
  EXPECT_TRUE(round.list[0].sets[0]);
  EXPECT_TRUE(round.list[0].holds({0, 5, 0}));
}

TEST(NodeConditions, VelocitiesAreThoseOfTheMiddlesOfStepsWhichTilesHaveOfTheirOwn) {
  const NodeConditions of_scene = conditions_of(moving_wall(Mode::plane_strain));
  const NodeConditions now = node_conditions(of_scene, {0.5, 0.25, 7});
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

TEST(NodeConditions, HomogeneousOnesHoldTheSameNodesAtRest) {
  const NodeConditions of_scene = conditions_of(moving_wall(Mode::plane_strain));
  const NodeConditions zero = homogeneous(node_conditions(of_scene, {0.5, 0.25, 7}));
  EXPECT_TRUE(zero.list[1].holds({5, 16, 0}));
  EXPECT_TRUE(zero.list[1].sets[1]);
  const PrescribedVelocities v = zero.over_step(0.5);
  EXPECT_EQ(v.before[1][1], 0.0);
  EXPECT_EQ(v.after[1][1], 0.0);
}

TEST(TimeTables, AreTheTablesToTheBit) {
  const std::vector<Table> tables{
      {{0.0}, {3.0}},
      {{0.1, 0.7, 0.7, 1.3}, {1.0, 0.3, -2.0, 0.1}},
      {{-1.0, 0.0, 1.0 / 3.0}, {0.7, 0.7, 5.0}}};
  const TimeTables view = make_time_tables(tables);
  for (int i = 0; i < 3; ++i)
    for (double t = -1.5; t < 1.7; t += 0.03125 / 3.0)
      EXPECT_EQ(view(i, t), tables[static_cast<std::size_t>(i)](t)) << i << " at " << t;
  EXPECT_EQ(view(1, 0.7), -2.0);
}

}  // namespace
}  // namespace barreno
