// SPDX-License-Identifier: BSD-3-Clause
// What moves a tile's particles over a step of several parts.
#include "step/subcycle/tile_steps.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// Two tiles side by side; the first takes one part of four at once, the second two.
class TileSteps : public ::testing::Test {
protected:
  TileSteps() : state(testing::in_tiles(scene(), 1.0)) {
    Subcycling& of = state.subcycling;
    of.parts = 4;
    of.period = ArrayView<int>("period", 2);
    of.ends = ArrayView<unsigned char>("ends", 2);
    of.solved = ArrayView<unsigned char>("solved", 2);
    of.gained = ArrayView<unsigned char>("gained", 2);
    of.elapsed = ArrayView<double>("elapsed", 2);
    of.gain = ArrayView<double>("gain", first_motion(state.grid.patch, 2));
    of.whole = ArrayView<double>("whole", first_motion(state.grid.patch, 2));
    of.period(0) = 1;
    of.period(1) = 2;
    of.solved(0) = of.solved(1) = 1;
  }
  static Scene scene() {
    Scene scene = testing::box_scene(
        Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
    );
    testing::add_box(scene, "block", {0.0, 0.0}, {16.0, 8.0}, 2);
    return scene;
  }
  const Nodes& nodes() const { return state.nodes.front(); }
  void start(double dt) const { start_tile_steps(state.grid, dt, state.subcycling); }
  void end(double dt) const { end_tile_steps(state.grid, dt, nodes(), state.subcycling); }
  void carry(double dt) const {
    carry_tile_steps(state.grid, dt, nodes(), state.dormancy, state.subcycling);
  }
  const double* whole() const { return &state.subcycling.whole(first_motion(state.grid.patch, 1)); }
  State state;
};

TEST_F(TileSteps, ATileThatGoesOnKeepsItsMomentaInStepWithItsNodes) {
  double* const sums = testing::sums_at(state, 0, 1, {12, 4});
  sums[0] = 3.0;
  sums[2] = 6.0;
  start(0.5);
  EXPECT_EQ(state.grid.tile_frame(0).dt, 0.5);
  EXPECT_EQ(state.grid.tile_frame(1).dt, 1.0);
  EXPECT_EQ(state.grid.tile_frame(1).part, 0.5);
  testing::set_motion(state, {0.0, 2.25, 0.0}, {0.0, 0.25, 0.0});
  end(0.5);
  EXPECT_EQ(state.subcycling.ends(0), 1);
  EXPECT_EQ(state.subcycling.ends(1), 0);
  carry(0.5);
  EXPECT_EQ(sums[2], 6.0 + 3.0 * 0.25);
}

TEST_F(TileSteps, AStepOfSeveralPartsHasTheSumsOfTheirPathsAndChanges) {
  start(0.5);
  testing::set_motion(state, {0.0, 2.25, 0.0}, {0.0, 0.25, 0.0});
  end(0.5);
  carry(0.5);
  state.subcycling.part = 1;
  start(0.25);  // a shorter one
  testing::set_motion(state, {0.0, 3.0, 0.0}, {0.0, 0.75, 0.0});
  end(0.25);
  EXPECT_EQ(state.subcycling.ends(1), 1);
  EXPECT_EQ(state.grid.tile_frame(1).dt, 0.75);
  EXPECT_EQ(state.grid.tile_frame(0).dt, 0.25);
  EXPECT_DOUBLE_EQ(whole()[1], (2.25 * 0.5 + 3.0 * 0.25 + 0.5 * 0.5 * 1.0) / 0.75);
  EXPECT_EQ(whole()[3], 1.0);
}

/// Under a force that stays the same: with the velocity after it.
TEST_F(TileSteps, AStepOfEqualPartsGoesAsFarAsOneOfThatLength) {
  start(0.5);
  testing::set_motion(state, {0.0, 2.25, 0.0}, {0.0, 0.25, 0.0});
  end(0.5);
  carry(0.5);
  state.subcycling.part = 1;
  start(0.5);
  testing::set_motion(state, {0.0, 2.5, 0.0}, {0.0, 0.25, 0.0});
  end(0.5);
  EXPECT_DOUBLE_EQ(whole()[1], 2.5);
  EXPECT_EQ(whole()[3], 0.5);
}

TEST_F(TileSteps, AllTilesMayEndTheirStepsWithAnyPart) {
  start(0.5);
  testing::set_motion(state, {0.0, 2.0, 0.0}, {0.0, 0.5, 0.0});
  end(0.5);
  end_other_tile_steps(state.grid, 0.5, nodes(), state.subcycling);
  EXPECT_EQ(state.subcycling.ends(0), 0);  // it has ended already
  EXPECT_EQ(state.subcycling.ends(1), 1);
  EXPECT_EQ(state.grid.tile_frame(1).dt, 0.5);
}

}  // namespace
}  // namespace barreno
