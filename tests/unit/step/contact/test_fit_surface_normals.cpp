// SPDX-License-Identifier: BSD-3-Clause
// Normals of the surface between two blocks.
#include "unit/step/contact/two_blocks.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::normal_at;

TEST(FitSurfaceNormals, OfTwoHalfSpacesIsTheirPlanes) {
  for (const Mode mode : testing::all_modes)
    for (const double h : {1.0, 0.25}) {
      const Scene scene = testing::two_blocks(mode, h, 0.0, ContactKind::frictionless);
      State state = testing::in_tiles(scene, 1.0);
      testing::meet(scene, state);
      const bool space = mode == Mode::three_dimensional;
      const std::vector<int> node = space ? std::vector<int>{4, 4, 4} : std::vector<int>{4, 4};
      for (int tile = 0; tile < state.grid.active; ++tile) {
        const TilePosition place = state.grid.tile_frame(tile).position;
        if (place[0] + place[1] + place[2] > 0) continue;
        const double* const n = normal_at(state, tile, node);
        EXPECT_NEAR(n[0], 1.0, 1e-12);
        EXPECT_NEAR(n[1], 0.0, 1e-12);
        if (space) EXPECT_NEAR(n[2], 0.0, 1e-12);
      }
    }
}

TEST(FitSurfaceNormals, ThereIsNoneWhereOneFieldIsAlone) {
  const Scene scene = testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::frictionless);
  State state = testing::in_tiles(scene, 1.0);
  testing::meet(scene, state);
  for (int d = 0; d < 2; ++d) EXPECT_EQ(normal_at(state, 0, {2, 4})[d], 0.0);
}

TEST(FitSurfaceNormals, BondedFieldsNeedNone) {
  const Scene scene = testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::bonded);
  EXPECT_FALSE(has_surfaces(velocity_fields(scene)));
  EXPECT_TRUE(has_surfaces(
      velocity_fields(testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::stick))
  ));
}

}  // namespace
}  // namespace barreno
