// SPDX-License-Identifier: BSD-3-Clause
// What becomes of tiles within their own steps after a part of a step.
#include "state/row_frames.hpp"
#include "step/end_part.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// A stiff block on a soft one, in tiles of their own, after some steps of up to four parts.
class EndPart : public ::testing::Test {
protected:
  EndPart() : scene(blocks()), state(testing::start_alone(scene)) {
    testing::advance_to(scene, 1e3, state, 3);
    // As after the first part of the last step: soft tiles are within theirs.
    Subcycling& of = state.subcycling;
    of.part = 0;
    of.ends_all = false;
    for (int tile = 0; tile < state.grid.active; ++tile) {
      const auto t = static_cast<std::size_t>(tile);
      of.ends(t) = of.period(t) == 1 ? 1 : 0;
      of.gained(t) = 0;
    }
  }
  static Scene blocks() {
    Scene scene = testing::box_scene(
        Mode::plane_strain, 1.0, {0.0, 0.0}, {8.0, 24.0}, testing::elastic(1.0, 0.0, 1.0)
    );
    scene.materials.push_back(testing::elastic(1.0 / 36.0, 0.0, 1.0));
    testing::add_box(scene, "stiff", {0.0, 0.0}, {8.0, 8.0}, 2).velocity = {0.0, 1e-3, 0.0};
    testing::add_box(scene, "soft", {0.0, 8.0}, {8.0, 16.0}, 2).material = 1;
    scene.step.subcycles = 4;
    return scene;
  }
  void after_part(double stable_step) {
    StepTally tally;
    tally.stress.stable_step = stable_step;
    StepResult result;
    end_or_carry_steps(scene, state.clock.dt, state, tally, result);
  }
  Scene scene;
  State state;
};

TEST_F(EndPart, StepsGoOnWhileTheStableStepHolds) {
  ASSERT_EQ(state.subcycling.parts, 4);
  ASSERT_EQ(state.subcycling.period(0), 1);
  ASSERT_EQ(state.subcycling.period(1), 4);
  after_part(0.95 * state.clock.dt);
  EXPECT_TRUE(goes_on(state.subcycling));
  prepare_next_part(state);
  EXPECT_EQ(state.subcycling.elapsed(1), state.clock.dt);
}

TEST_F(EndPart, AllTilesMeetWhereTheStableStepHasFallen) {
  after_part(0.85 * state.clock.dt);
  EXPECT_FALSE(goes_on(state.subcycling));
  EXPECT_EQ(state.subcycling.ends(1), 1);
  EXPECT_EQ(state.grid.tile_frame(1).dt, state.clock.dt);
}

TEST_F(EndPart, TheNextPartFindsStraysWhereTheyHaveComeTo) {
  Particles& stiff = state.particles[0];
  const int p = stiff.order(0);
  stiff.position(p, 1) = 8.5;
  state.subcycling.ends(0) = 1;
  state.subcycling.strays = true;
  prepare_next_part(state);
  EXPECT_EQ(state.subcycling.part, 1);
  EXPECT_EQ(RowFrames(state.grid, stiff).tile(p), 1);
}

}  // namespace
}  // namespace barreno
