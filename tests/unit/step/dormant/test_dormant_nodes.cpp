// SPDX-License-Identifier: BSD-3-Clause
// Whose nodes move too little to be solved again.
#include "grid/tiles.hpp"
#include "state/nodes.hpp"
#include "step/dormant/dormant_nodes.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace barreno {
namespace {

/// One tile that is a candidate; nodes may move 1e-3 of a cell of size 2 in a step of 0.5: 4e-3.
class DormantNodesTest : public ::testing::Test {
protected:
  DormantNodesTest()
      : state(testing::start_alone(testing::box_scene(
            Mode::plane_strain, 2.0, {0.0, 0.0}, {16.0, 16.0}, testing::elastic(1e6, 0.3, 1000.0)
        ))) {
    activate_tiles(state.grid, {0});
    set_tile_steps(state.grid, 0.5);
    Dormancy& dormancy = state.dormancy;
    dormancy.on = true;
    dormancy.motion = 1e-3;
    dormancy.candidate = ArrayView<unsigned char>("candidate", 1);
    dormancy.motionless = ArrayView<unsigned char>("motionless", 1);
    dormancy.unsolved = ArrayView<unsigned char>("unsolved", 1);
    dormancy.speed = ArrayView<double>("speed", 1);
    dormancy.acceleration = ArrayView<double>("acceleration", 1);
    nodes.sums_kept = ArrayView<unsigned char>("sums_kept", 1);
    dormancy.candidate(0) = 1;
    nodes.sums_kept(0) = 1;
    motion.assign(first_motion(state.grid.patch, 1), 0.0);
  }
  /// Velocity after the step and its change, along y at a node.
  void move(double velocity, double change) {
    motion[4 * 7 + 1] = velocity;
    motion[4 * 7 + 3] = change;
  }
  DormantNodes rule(bool first_field = true) const {
    return {state.grid, state.dormancy, first_field, state.subcycling, nodes};
  }

  State state;
  Nodes nodes;
  std::vector<double> motion;
};

TEST_F(DormantNodesTest, ATileIsMotionlessUpToTheLimitOfItsCellsAndStep) {
  EXPECT_DOUBLE_EQ(rule().limit(0), 4e-3);
  move(-3.9e-3, 3.9e-3);
  EXPECT_TRUE(rule().enter(0, motion.data(), false));
  EXPECT_EQ(state.dormancy.motionless(0), 1);
  move(4.1e-3, 0.0);
  EXPECT_FALSE(rule().enter(0, motion.data(), false));
  EXPECT_EQ(state.dormancy.motionless(0), 0);
  move(0.0, -4.1e-3);  // it stops: so does what it had
  EXPECT_FALSE(rule().enter(0, motion.data(), false));
  move(std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_FALSE(rule().enter(0, motion.data(), false));
}

TEST_F(DormantNodesTest, BoundsOfTheLastSolveSayWhetherItStaysSo) {
  move(1e-3, 1e-3);
  rule().enter(0, motion.data(), false);
  EXPECT_EQ(state.dormancy.speed(0), 2e-3);
  EXPECT_EQ(state.dormancy.acceleration(0), 2e-3);
  EXPECT_TRUE(rule().stays_motionless(0));  // 2e-3 + 0.5 * 2e-3 <= 4e-3
  set_tile_steps(state.grid, 1.0);          // 2e-3 + 2e-3 > 2e-3
  EXPECT_FALSE(rule().stays_motionless(0));
  set_tile_steps(state.grid, 0.5);
  nodes.sums_kept(0) = 0;
  EXPECT_FALSE(rule().stays_motionless(0));
}

/// Velocity fields are solved one after the other.
TEST_F(DormantNodesTest, ATileIsMotionlessIfAllFieldsAre) {
  move(1e-3, 1e-3);
  EXPECT_TRUE(rule(true).enter(0, motion.data(), false));
  move(1.5e-3, 0.5e-3);
  EXPECT_TRUE(rule(false).enter(0, motion.data(), false));
  EXPECT_EQ(state.dormancy.speed(0), 2e-3);
  EXPECT_EQ(state.dormancy.acceleration(0), 2e-3);
  EXPECT_TRUE(rule(true).stays_motionless(0));
  rule(true).enter(0, motion.data(), false);
  move(5e-3, 0.0);
  EXPECT_FALSE(rule(false).enter(0, motion.data(), false));
  EXPECT_EQ(state.dormancy.motionless(0), 0);
  EXPECT_FALSE(rule(true).stays_motionless(0));
  move(0.0, 0.0);
  EXPECT_TRUE(rule(true).enter(0, motion.data(), false));
  EXPECT_TRUE(rule(false).enter(0, motion.data(), false));
  EXPECT_EQ(state.dormancy.motionless(0), 1);
}

TEST_F(DormantNodesTest, AConditionOnANodeHasItSolvedInEveryStep) {
  EXPECT_FALSE(rule().enter(0, motion.data(), true));
  EXPECT_EQ(state.dormancy.motionless(0), 1);
  EXPECT_FALSE(rule().stays_motionless(0));
}

}  // namespace
}  // namespace barreno
