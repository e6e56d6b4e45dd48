// SPDX-License-Identifier: BSD-3-Clause
// Conditions of the faces of the grid: the nodes that they hold.
#include "unit/step/boundary/moving_wall.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::conditions_of;
using testing::moving_wall;

TEST(NodeConditions, HoldTheNodesAtAndBehindTheirFaces) {
  const NodeConditions plane = conditions_of(moving_wall(Mode::plane_strain));
  ASSERT_EQ(plane.count, 2);
  EXPECT_TRUE(plane.list[0].holds({0, 5, 0}, 0));
  EXPECT_TRUE(plane.list[0].holds({-1, 5, 0}, 0));
  EXPECT_FALSE(plane.list[0].holds({1, 5, 0}, 0));
  EXPECT_TRUE(plane.list[0].sets[0]);
  EXPECT_FALSE(plane.list[0].sets[1]);
  EXPECT_TRUE(plane.list[1].holds({5, 16, 0}, 0));
  EXPECT_FALSE(plane.list[1].holds({5, 15, 0}, 0));
  // On a lattice twice as fine the face has twice the index.
  EXPECT_TRUE(plane.list[1].holds({5, 32, 0}, 1));
  EXPECT_FALSE(plane.list[1].holds({5, 31, 0}, 1));
  EXPECT_TRUE(plane.list[1].sets[0]);
  EXPECT_TRUE(plane.list[1].sets[1]);
  // The axis of revolution needs nobody to ask for it.
  const NodeConditions round = conditions_of(moving_wall(Mode::axisymmetric));
  ASSERT_EQ(round.count, 3);
  EXPECT_TRUE(round.list[0].sets[0]);
  EXPECT_TRUE(round.list[0].holds({0, 5, 0}, 0));
}

}  // namespace
}  // namespace barreno
