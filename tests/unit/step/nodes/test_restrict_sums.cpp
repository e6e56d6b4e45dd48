// SPDX-License-Identifier: BSD-3-Clause
// What a refined tile gives to the coarser one that holds it.
#include "scene/tile_levels.hpp"
#include "step/nodes/restrict_sums.hpp"
#include "step/prepare_step.hpp"
#include "step/transfer/project_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// One tile of level 0, all of it refined, and beside it one that is not.
struct TwoTiles {
  Scene scene;
  State state;

  TwoTiles()
      : scene(testing::box_scene(
            Mode::plane_strain, 1.0, {}, {16.0, 8.0, 0.0}, testing::elastic(70e9, 0.3, 2700.0)
        )) {
    testing::add_box(scene, "all", {}, {16.0, 8.0, 0.0}, 2);
    scene.grid.level_of_tile = find_tile_levels(scene.grid, {{Box{{}, {8.0, 8.0, 0.0}}, 1}});
    state = testing::start_alone(scene);
    prepare_step(scene, 1.0, state);
    clear_nodes(state.grid, state.nodes[0]);
  }

  int tile_at(const TilePosition& at) const { return state.grid.directory(state.grid.box.id(at)); }
  /// Mass of a node of a tile, counted from the tile's own first node.
  double& mass(int tile, int x, int y) {
    const Patch& patch = state.grid.patch;
    const int slot = (y + patch.reach) * patch.nodes + x + patch.reach;
    return state.nodes[0].sums(
        first_sum(patch, tile) + static_cast<std::size_t>(slot) * sum_components
    );
  }
};

TEST(RestrictSums, OfANodeThatTheCoarserLatticeHasGoToThatNode) {
  TwoTiles tiles;
  const int parent = tiles.tile_at({{0, 0, 0}, 0}), finer = tiles.tile_at({{0, 1, 0}, 1});
  tiles.mass(finer, 2, 4) = 3.0;  // 8 finer cells up: 12 in all, 6 of the coarser
  restrict_sums(tiles.state.grid, tiles.state.nodes[0]);
  EXPECT_EQ(tiles.mass(parent, 1, 6), 3.0);
}

TEST(RestrictSums, OfANodeOnTheBorderGoToTheTwoBesideIt) {
  TwoTiles tiles;
  const int parent = tiles.tile_at({{0, 0, 0}, 0}), finer = tiles.tile_at({{1, 0, 0}, 1});
  tiles.mass(finer, 8, 3) = 3.0;
  restrict_sums(tiles.state.grid, tiles.state.nodes[0]);
  EXPECT_EQ(tiles.mass(parent, 8, 1), 1.5);
  EXPECT_EQ(tiles.mass(parent, 8, 2), 1.5);
}

TEST(RestrictSums, OfAnUnknownOfTheRefinedTileStayThere) {
  TwoTiles tiles;
  const int parent = tiles.tile_at({{0, 0, 0}, 0}), finer = tiles.tile_at({{0, 0, 0}, 1});
  tiles.mass(finer, 3, 2) = 3.0;
  restrict_sums(tiles.state.grid, tiles.state.nodes[0]);
  EXPECT_EQ(tiles.mass(finer, 3, 2), 3.0);
  for (int x = 0; x < 9; ++x)
    for (int y = 0; y < 9; ++y) EXPECT_EQ(tiles.mass(parent, x, y), 0.0);
}

}  // namespace
}  // namespace barreno
