// SPDX-License-Identifier: BSD-3-Clause
// Whose nodes are left as the last step solved them, where finer tiles take nodes from coarser
// ones.
#include "grid/tiles.hpp"
#include "scene/tile_levels.hpp"
#include "step/dormant/find_dormant_tiles.hpp"
#include "step/dormant/find_unsolved_tiles.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <set>

namespace barreno {
namespace {

/// A block at rest whose left half has cells half as wide, in tiles whose sums hold and whose nodes
/// did not move.
class UnsolvedTilesTest : public ::testing::Test {
protected:
  UnsolvedTilesTest() : state(testing::start_in_tiles(half_refined())) {
    set_tile_steps(state.grid, 1e-6);
    find_dormant_candidates(
        state.grid,
        state.particles,
        state.subcycling,
        state.dormancy,
        state.nodes,
        state.effort,
        0.0
    );
    for (int tile = 0; tile < state.grid.active; ++tile) {
      state.dormancy.candidate(tile) = 1;
      state.dormancy.speed(tile) = state.dormancy.acceleration(tile) = 0.0;
      state.nodes.front().sums_kept(tile) = sums_as_were;
    }
  }
  static Scene half_refined() {
    Scene out = testing::box_scene(
        Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
    );
    testing::add_box(out, "block", {0.0, 0.0}, {16.0, 8.0}, 2);
    out.grid.level_of_tile = find_tile_levels(out.grid, {{Box{{0.0, 0.0}, {8.0, 8.0}}, 1}});
    return out;
  }
  std::set<int> solved() {
    find_unsolved_tiles(
        state.grid, {state.grid, state.dormancy, true, state.subcycling, state.nodes.front()}
    );
    std::set<int> out;
    for (int tile = 0; tile < state.grid.active; ++tile)
      if (state.dormancy.unsolved(tile) == 0) out.insert(tile);
    return out;
  }
  int first_fine() const { return state.grid.first_of_level[1]; }
  /// More than a tile may have, so that it is solved.
  void let_move(int tile) { state.dormancy.speed(tile) = 1.0; }

  State state;
};

TEST_F(UnsolvedTilesTest, AreThoseThatStayMotionless) {
  ASSERT_EQ(state.grid.active, 6);  // two of the coarser cells and four of the smaller ones
  EXPECT_EQ(solved(), std::set<int>{});
  let_move(1);
  EXPECT_EQ(solved(), std::set<int>{1});
}

TEST_F(UnsolvedTilesTest, ATileIsSolvedWithTheFinerOnesInIt) {
  const int fine = first_fine() + 2;
  let_move(fine);
  EXPECT_EQ(solved(), (std::set<int>{state.grid.parent(fine), fine}));
}

/// What its nodes did in this step is known without solving them.
TEST_F(UnsolvedTilesTest, TheyAreMotionless) {
  state.dormancy.motionless(1) = 0;
  solved();
  EXPECT_EQ(state.dormancy.motionless(1), 1);
}

}  // namespace
}  // namespace barreno
