// SPDX-License-Identifier: BSD-3-Clause
// What moves a tile's particles over a step of several parts.
#include "step/subcycle/tile_steps.hpp"
#include "step/subcycle/whole_motion.hpp"
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
    of.length = 0.5;
    of.node_period = ArrayView<unsigned char>("node_period", nodes_of_tiles());
    of.node_periods = ArrayView<unsigned char>("node_periods", 2);
    all_nodes_take(0, 1);
    all_nodes_take(1, 1);
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
  std::size_t nodes_of_tiles() const { return 2 * static_cast<std::size_t>(state.grid.patch.size); }
  /// So many parts at once.
  void all_nodes_take(int tile, unsigned char parts) const {
    const int size = state.grid.patch.size;
    for (int slot = 0; slot < size; ++slot)
      state.subcycling.node_period(tile * size + slot) = parts;
    state.subcycling.node_periods(tile) = parts;
  }
  void start(double dt) const { start_tile_steps(state.grid, dt, state.subcycling); }
  void end() const { end_tile_steps(state.grid, nodes(), state.subcycling); }
  void carry() const { carry_tile_steps(state.grid, nodes(), state.dormancy, state.subcycling); }
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
  end();
  EXPECT_EQ(state.subcycling.ends(0), 1);
  EXPECT_EQ(state.subcycling.ends(1), 0);
  carry();
  EXPECT_EQ(sums[2], 6.0 + 3.0 * 0.25);
}

TEST_F(TileSteps, AStepOfSeveralPartsHasTheSumsOfTheirPathsAndChanges) {
  start(0.5);
  testing::set_motion(state, {0.0, 2.25, 0.0}, {0.0, 0.25, 0.0});
  end();
  carry();
  state.subcycling.part = 1;
  start(0.25);  // a shorter one
  testing::set_motion(state, {0.0, 3.0, 0.0}, {0.0, 0.75, 0.0});
  end();
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
  end();
  carry();
  state.subcycling.part = 1;
  start(0.5);
  testing::set_motion(state, {0.0, 2.5, 0.0}, {0.0, 0.25, 0.0});
  end();
  EXPECT_DOUBLE_EQ(whole()[1], 2.5);
  EXPECT_EQ(whole()[3], 0.5);
}

/// Of four parts, of which a node takes one, two or all at once.
TEST_F(TileSteps, ItGoesAsFarHoweverManyPartsANodeTakesAtOnce) {
  const int size = state.grid.patch.size;
  state.subcycling.period(1) = 4;
  for (const int taken : {1, 2, 4}) {
    SCOPED_TRACE(taken);
    all_nodes_take(1, static_cast<unsigned char>(taken));
    state.subcycling.node_period(size) = taken == 1 ? 4 : 1;  // another at the corner
    state.subcycling.node_periods(1) = static_cast<unsigned char>(taken | (taken == 1 ? 4 : 1));
    double* const sums = testing::sums_at(state, 0, 1, {12, 4});
    sums[0] = 3.0;
    sums[2] = 6.0;
    for (int part = 0; part < 4; ++part) {
      state.subcycling.part = part;
      start(0.5);
      if ((part + 1) % taken == 0) {
        const double gained = 0.25 * taken;  // a quarter in each part
        testing::set_motion(state, {0.0, 2.0 + 0.25 * (part + 1), 0.0}, {0.0, gained, 0.0});
      }
      end();
      if (part < 3) carry();
    }
    const int slot = testing::slot_of(state.grid, 1, {12, 4});
    const double* const of_node = whole() + slot * motion_components(2);
    EXPECT_DOUBLE_EQ(of_node[1], 3.0);
    EXPECT_EQ(of_node[3], 1.0);
    EXPECT_EQ(sums[2], 6.0 + 3.0 * 0.25 * (taken == 4 ? 0 : taken == 2 ? 2 : 3));
    const WholeMotion found{
        state.grid.patch, state.grid.tile_frame, nodes().motion, state.subcycling};
    double out[4];
    found.find(1, slot, out);
    EXPECT_EQ(out[1], of_node[1]);
    EXPECT_EQ(out[3], of_node[3]);
  }
}

/// Its particles take the motion of its nodes as it is.
TEST_F(TileSteps, ATileWhoseNodesWaitForItsEndCarriesNothing) {
  all_nodes_take(1, 2);
  double* const sums = testing::sums_at(state, 0, 1, {12, 4});
  sums[0] = 3.0;
  sums[2] = 6.0;
  start(0.5);
  EXPECT_EQ(state.subcycling.solved_periods(1), 0);
  state.subcycling.solved(1) = 0;
  testing::set_motion(state, {0.0, 2.25, 0.0}, {0.0, 0.25, 0.0});
  end();
  carry();
  EXPECT_EQ(sums[2], 6.0);
  EXPECT_EQ(state.subcycling.gained(1), 0);
  state.subcycling.part = 1;
  EXPECT_EQ(state.subcycling.solved_periods(1), 2);
  EXPECT_FALSE(state.subcycling.takes_whole(1));
}

TEST_F(TileSteps, AllTilesMayEndTheirStepsWithAnyPart) {
  start(0.5);
  testing::set_motion(state, {0.0, 2.0, 0.0}, {0.0, 0.5, 0.0});
  end();
  end_other_tile_steps(state.grid, nodes(), state.subcycling);
  EXPECT_EQ(state.subcycling.ends(0), 0);  // it has ended already
  EXPECT_EQ(state.subcycling.ends(1), 1);
  EXPECT_EQ(state.grid.tile_frame(1).dt, 0.5);
}

}  // namespace
}  // namespace barreno
