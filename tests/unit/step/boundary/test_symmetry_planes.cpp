// SPDX-License-Identifier: BSD-3-Clause
// Planes of symmetry as kernels read them, and the images of the nodes behind them.
#include "step/boundary/symmetry_planes.hpp"
#include "unit/step/boundary/two_tiles_along_y.hpp"

#include <gtest/gtest.h>

#include <map>

namespace barreno {
namespace {

/// Whether planes hold a node of the box, by its number on the lattice of a level, seen from the
/// tile at the box's lower corner.
bool hold(const SymmetryPlanes& planes, const Patch& patch, int axis, int node, int level = 0) {
  return planes.holds(axis, patch, {{0, 0, 0}, level}, node + patch.reach);
}

TEST(SymmetryPlanes, AreFacesOfTheGridThoseAcrossYLast) {
  const Scene scene = testing::two_tiles_along_y({Face::y_lower, Face::x_upper});
  const State state = testing::in_tiles(scene, 1.0);
  const SymmetryPlanes planes(scene.conditions, state.grid);
  ASSERT_EQ(planes.count, 2);
  EXPECT_EQ(planes.list[0].axis, 0);
  EXPECT_EQ(planes.list[0].node, 8);
  EXPECT_TRUE(planes.list[0].is_behind(9, 0));
  EXPECT_FALSE(planes.list[0].is_behind(8, 0));
  EXPECT_EQ(planes.list[1].axis, 1);
  EXPECT_TRUE(planes.list[1].is_behind(-1, 0));
  EXPECT_TRUE(planes.any_axial);
  const Patch& patch = state.grid.patch;
  EXPECT_TRUE(hold(planes, patch, 0, 8));
  EXPECT_FALSE(hold(planes, patch, 0, 0));
  EXPECT_FALSE(hold(planes, patch, 0, 8, 1)) << "half way in cells of half the size";
  EXPECT_TRUE(hold(planes, patch, 0, 16, 1));
}

TEST(SymmetryPlanes, TheAxisOfRevolutionIsOneForCloudsOnly) {
  Scene scene = testing::two_tiles_along_y({});
  scene.grid.mode = Mode::axisymmetric;
  const State state = testing::in_tiles(scene, 1.0);
  const SymmetryPlanes planes(scene.conditions, state.grid);
  EXPECT_EQ(planes.count, 0);
  const Patch& patch = state.grid.patch;
  EXPECT_TRUE(hold(planes, patch, 0, 0));
  EXPECT_FALSE(hold(planes, patch, 0, 1));
  EXPECT_FALSE(hold(planes, patch, 1, 0));
}

TEST(SymmetryPlanes, ImagesLieAsFarBeforeThePlaneAsTheirNodesBehindIt) {
  const Scene scene = testing::two_tiles_along_y({Face::y_upper});
  const State state = testing::in_tiles(scene, 1.0);
  const SymmetryPlane& plane = SymmetryPlanes(scene.conditions, state.grid).list[0];
  const Patch& patch = state.grid.patch;
  for (int tile = 0; tile < 2; ++tile) {
    const TilePosition position = state.grid.tile_frame(tile).position;
    EXPECT_EQ(SymmetryPlanes::reaches(plane, patch, position), position[1] == 1);
    std::map<int, int> images;
    SymmetryPlanes::for_each_image(plane, patch, position, [&](int behind, int image) {
      images[behind] = image;
    });
    if (position[1] == 0) {
      EXPECT_TRUE(images.empty());
      continue;
    }
    ASSERT_EQ(images.size(), static_cast<std::size_t>(patch.nodes * patch.reach));
    for (int x = 0; x <= 8; ++x)
      EXPECT_EQ(
          images.at(testing::slot_of(state.grid, tile, {x, 17})),
          testing::slot_of(state.grid, tile, {x, 15})
      );
  }
}

}  // namespace
}  // namespace barreno
