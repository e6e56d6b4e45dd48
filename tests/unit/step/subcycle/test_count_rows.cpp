// SPDX-License-Identifier: BSD-3-Clause
// How many particles tiles have.
#include "step/subcycle/count_rows.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(CountRows, AddsAllSetsAndForgetsWhatWasThere) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0}, {12.0, 8.0}, 2);
  const State state = testing::in_tiles(scene, 1.0);
  const ArrayView<int> rows("rows", 2);
  rows(0) = rows(1) = 7;
  count_rows(state.grid, state.particles, rows);
  EXPECT_EQ(rows(0), 8 * 8 * 4);
  EXPECT_EQ(rows(1), 4 * 8 * 4);
  count_rows(state.grid, {state.particles[0], state.particles[0]}, rows);
  EXPECT_EQ(rows(0), 2 * 8 * 8 * 4);
  EXPECT_EQ(rows(1), 2 * 4 * 8 * 4);
}

}  // namespace
}  // namespace barreno
