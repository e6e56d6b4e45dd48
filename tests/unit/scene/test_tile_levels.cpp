// SPDX-License-Identifier: BSD-3-Clause
// Levels of tiles from regions, and the particles that they ask for.
#include "scene/jet.hpp"
#include "scene/tile_levels.hpp"
#include "state/bodies/body_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::all_modes;
using testing::box_scene;

constexpr double h = 1e-3;

constexpr double tile = 8 * h;

/// 6 tiles along x and y, and 2 along z.
Scene scene_of(Mode mode) {
  return box_scene(mode, h, {}, {6 * tile, 6 * tile, 2 * tile}, testing::copper());
}
RefinedRegion corner_region(int level) {
  return {Box{{}, {0.5 * tile, 0.5 * tile, 0.5 * tile}}, level};
}

TEST(TileLevels, NeighboursDifferByOneCornersIncluded) {
  for (const Mode mode : all_modes) {
    Scene scene = scene_of(mode);
    scene.grid.level_of_tile = find_tile_levels(scene.grid, {corner_region(3)});
    const auto level = [&](int x, int y) {
      return level_at(scene.grid, {(x + 0.5) * tile, (y + 0.5) * tile, 0.5 * tile});
    };
    EXPECT_EQ(level(0, 0), 3);
    for (int x = 0; x < 6; ++x)
      for (int y = 0; y < 6; ++y) EXPECT_EQ(level(x, y), std::max(0, 3 - std::max(x, y)));
    EXPECT_EQ(finest_level(scene.grid), 3);
  }
}

TEST(TileLevels, TheFinestOfTwoRegionsCounts) {
  Scene scene = scene_of(Mode::plane_strain);
  const RefinedRegion all{Box{{}, {6 * tile, 6 * tile, 0.0}}, 1};
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {corner_region(2), all});
  EXPECT_EQ(level_at(scene.grid, {0.0, 0.0, 0.0}), 2);
  EXPECT_EQ(level_at(scene.grid, {5.5 * tile, 5.5 * tile, 0.0}), 1);
}

TEST(TileLevels, ARegionThatOnlyTouchesATileLeavesIt) {
  const Scene scene = scene_of(Mode::plane_strain);
  const RefinedRegion region{Box{{tile, tile, 0.0}, {2 * tile, 2 * tile, 0.0}}, 1};
  const auto levels = find_tile_levels(scene.grid, {region});
  EXPECT_EQ(std::count(levels.begin(), levels.end(), 1), 1);
  EXPECT_EQ(levels[7], 1);
}

/// A strip along y, that many usual tiles wide, of half as large cells.
RefinedRegion strip(double width) {
  return {Box{{}, {width * tile, 6 * tile, 2 * tile}}, 1};
}

TEST(TileLevels, ANarrowStripHasSmallTiles) {
  Scene scene = scene_of(Mode::plane_strain);
  scene.grid.level_of_tile = find_cheapest_levels(scene.grid, {strip(0.4)});
  EXPECT_EQ(tile_size_of(scene.grid), 0.5 * tile);
  EXPECT_EQ(box_tiles(scene.grid), (std::array<int, 3>{12, 12, 1}));
  EXPECT_EQ(level_at(scene.grid, {0.49 * tile, 3.1 * tile, 0.0}), 1);
  EXPECT_EQ(level_at(scene.grid, {0.51 * tile, 3.1 * tile, 0.0}), 0);
  const Box half{{}, {tile, 6 * tile, 0.0}};  // of which a half is refined
  EXPECT_DOUBLE_EQ(refined_share(scene.grid, half), 0.5 * (4.0 + 1.0));
}

TEST(TileLevels, TilesAreAsUsualWhereSmallOnesSaveNothing) {
  for (const Mode mode : all_modes) {
    Scene scene = scene_of(mode);
    scene.grid.level_of_tile = find_cheapest_levels(scene.grid, {strip(0.9)});
    EXPECT_EQ(scene.grid.level_of_tile, find_tile_levels(scene.grid, {strip(0.9)}));
    EXPECT_EQ(tile_size_of(scene.grid), tile);
  }
  EXPECT_TRUE(find_cheapest_levels(scene_of(Mode::plane_strain).grid, {}).empty());
}

TEST(TileLevels, WithoutRegionsNothingIsKept) {
  EXPECT_TRUE(find_tile_levels(scene_of(Mode::plane_strain).grid, {}).empty());
  EXPECT_EQ(finest_level(scene_of(Mode::plane_strain).grid), 0);
}

/// Volume and first moments are those of the uniform grid's particles (rings of another radius have
/// another moment across the axis, as they do on a finer uniform grid), and the ids have no gaps.
TEST(TileLevels, BodiesKeepTheirVolumeAndCentroid) {
  for (const Mode mode : all_modes) {
    Scene scene = scene_of(mode);
    const BodySpec& body = add_box(scene, "body", {}, {2.3 * tile, 3.1 * tile, 1.2 * tile}, 2);
    const auto sums_of = [&] {
      std::array<long double, 4> sums{};
      for_each_body_particle(scene.grid, body, 7, [&](const NewParticle& p) {
        sums[0] += p.volume;
        for (std::size_t d = 0; d < 2; ++d) sums[d + 1] += p.volume * p.x[d];
        EXPECT_EQ(p.id, 7 + std::llround(sums[3]));
        sums[3] += 1.0;
      });
      return sums;
    };
    const auto uniform = sums_of();
    scene.grid.level_of_tile = find_tile_levels(scene.grid, {corner_region(2)});
    const auto refined = sums_of();
    for (std::size_t i = 0; i < 3; ++i) {
      if (mode == Mode::axisymmetric && i == 1) continue;
      EXPECT_NEAR(static_cast<double>(refined[i] / uniform[i]), 1.0, 1e-13);
    }
    EXPECT_EQ(count_body_particles(scene.grid, body), std::llround(refined[3]));
    // The share counts areas, and particles belong to one tile each.
    const auto share = static_cast<double>(refined[3] / uniform[3]);
    EXPECT_GT(share, 1.5);
    EXPECT_NEAR(refined_share(scene.grid, std::get<Box>(body.shape)) / share, 1.0, 0.2);
  }
}

/// Slugs of 1.2 and 3 mm in cells of 1 mm: 4 cells per radius are 0.25 mm, from 0.3 mm wanted.
TEST(JetPath, IsRefinedForTheThinnestSlug) {
  Scene scene = scene_of(Mode::axisymmetric);
  JetSpec& jet = scene.jet;
  jet.present = true;
  jet.launch_position = 1e-3;
  jet.slugs = {{0.0, 1000.0, 3e-3, 1e-3, 8930.0}, {0.0, 900.0, 1.2e-3, 1e-3, 8930.0}};
  add_box(scene, "target", {0.0, 20e-3, 0.0}, {40e-3, 40e-3, 0.0}, 2);
  EXPECT_EQ(path_of_jet(scene.grid, jet).level, 0);
  EXPECT_EQ(cell_size_of_path(scene), 1e-3);
  jet.cells_per_radius = 4.0;
  const RefinedRegion path = path_of_jet(scene.grid, jet);
  EXPECT_EQ(path.level, 2);
  EXPECT_DOUBLE_EQ(std::get<Box>(path.shape).upper[0], 7.5e-3);
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {path});
  EXPECT_EQ(cell_size_of_path(scene), 0.25e-3);
  EXPECT_EQ(grid_of_jet(scene.grid, jet).cell_size, 0.25e-3);
  // Where only a part of the path is refined, its largest cells count.
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {{Box{{}, {8e-3, 8e-3, 0.0}}, 2}});
  EXPECT_EQ(cell_size_of_path(scene), 1e-3);
}

}  // namespace
}  // namespace barreno
