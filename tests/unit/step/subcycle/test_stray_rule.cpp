// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/stray_rule.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// The side on which the first particle of the first tile, which is half a cell wide, is too far
/// from its tile, when it is so many cells from the tile's lower face along x.
int side_at(const char* shape, double cells) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 16.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0}, {8.0, 8.0}, 2);
  State state = testing::in_tiles(scene, 1.0);
  state.grid.shape = shape;
  const Particles& particles = state.particles[0];
  const TileFrame& of = state.grid.tile_frame(0);
  return StrayRule(state.grid, particles).side_of(cells, 0, particles.order(0), of);
}

TEST(StrayRule, GimpReachesNineTenthsOfItsHalfSizeBeyondItsTile) {
  EXPECT_EQ(side_at("GIMP", 8.22), 0);
  EXPECT_EQ(side_at("GIMP", 8.23), 1);
  EXPECT_EQ(side_at("GIMP", -0.22), 0);
  EXPECT_EQ(side_at("GIMP", -0.23), -1);
}

TEST(StrayRule, OtherShapeFunctionsHaveNoRoom) {
  EXPECT_EQ(side_at("quadratic B-spline", 7.99), 0);
  EXPECT_EQ(side_at("quadratic B-spline", 8.01), 1);
  EXPECT_EQ(side_at("quadratic B-spline", -0.01), -1);
}

}  // namespace
}  // namespace barreno
