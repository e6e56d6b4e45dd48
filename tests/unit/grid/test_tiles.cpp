// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/exchange.hpp"
#include "grid/grid.hpp"
#include "grid/halo.hpp"
#include "grid/make_patch.hpp"
#include "grid/parcels.hpp"
#include "grid/patch.hpp"
#include "grid/tile_directory.hpp"
#include "grid/tiles.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace barreno {
namespace {

/// 20 x 12 cells of size 0.5, which take 3 x 2 tiles.
Scene scene_of_six_tiles() {
  Scene scene;
  scene.grid = {Mode::plane_strain, {1.0, -2.0, 0.0}, {11.0, 4.0, 0.0}, 0.5, {}};
  scene.conditions.push_back({"floor", Face::y_lower, ConditionKind::symmetry, {}});
  scene.conditions.push_back({"roof", Face::y_upper, ConditionKind::fixed, {}});
  return scene;
}

Grid alone(int reach) {
  return make_grid(scene_of_six_tiles(), reach, Teuchos::rcp(new Teuchos::SerialComm<int>));
}

TEST(Patch, HasTheNodesOfItsTileAndThoseInReach) {
  const Patch flat = make_patch(2, 1), solid = make_patch(3, 2, 2);
  EXPECT_EQ(flat.tile_cells, 8);
  EXPECT_EQ(flat.nodes, 11);  // 9 of the tile, one more on either side
  EXPECT_EQ(flat.size, 121);
  EXPECT_EQ(flat.neighbours, 9);
  EXPECT_EQ(flat.nodes_along(2), 1);
  EXPECT_EQ(solid.tile_cells, 4);
  EXPECT_EQ(solid.nodes, 9);
  EXPECT_EQ(solid.near, 2);  // two tiles on, the last node of one is the first of the other
  EXPECT_EQ(solid.neighbours, 125);
  EXPECT_THROW(make_patch(2, 28), std::logic_error);
}

TEST(Patch, OverlapsWithANeighbourFromBothSidesAlike) {
  const Patch patch = make_patch(2, 1);
  EXPECT_EQ(patch.overlap_begin(1), 8);
  EXPECT_EQ(patch.overlap_end(1), 11);
  EXPECT_EQ(patch.overlap_begin(-1), 0);
  EXPECT_EQ(patch.overlap_end(-1), 3);
  int at[2];
  position_of_slot(patch, 4 * 11 + 7, at);
  EXPECT_EQ(at[0], 7);
  EXPECT_EQ(at[1], 4);
  std::vector<int> along_x;
  for_each_neighbour(patch, [&](int k, int x, int, int) {
    EXPECT_EQ(k, static_cast<int>(along_x.size()));
    along_x.push_back(x);
  });
  EXPECT_EQ(along_x, (std::vector<int>{-1, 0, 1, -1, 0, 1, -1, 0, 1}));
}

TEST(Grid, KnowsWhatItsSceneAsksFor) {
  const Grid grid = alone(1);
  EXPECT_EQ(grid.cells[0], 20);
  EXPECT_EQ(grid.tiles[0], 3);
  EXPECT_EQ(grid.tiles[1], 2);
  EXPECT_EQ(grid.active, 0);
  EXPECT_TRUE(grid.mirrored[static_cast<int>(Face::y_lower)]);
  EXPECT_FALSE(grid.mirrored[static_cast<int>(Face::y_upper)]);
  EXPECT_EQ(grid.box.id({{2, 1, 0}, 0}), 5);
  EXPECT_EQ(grid.box.position(5)[0], 2);
  EXPECT_EQ(grid.box.position(5)[1], 1);
  EXPECT_FALSE(grid.box.has({{3, 0, 0}, 0}));
}

/// Tiles of all levels have numbers of their own, and find those around them.
TEST(BoxTiles, NumberTilesLevelByLevel) {
  for (const int dimension : {2, 3}) {
    const BoxTiles box(dimension, 3, {3, 2, dimension == 3 ? 2 : 1});
    for (int id = 0; id < box.first_id[3]; ++id) {
      const TilePosition at = box.position(id);
      EXPECT_TRUE(box.has(at));
      EXPECT_EQ(box.id(at), id);
      if (at.level == 0) {
        EXPECT_EQ(box.box_tile(at), id);
      } else {
        EXPECT_EQ(box.box_tile(box.parent(at)), box.box_tile(at));
      }
    }
    EXPECT_EQ(box.first_id[1], dimension == 3 ? 12 : 6);
    EXPECT_EQ(box.first_id[2], box.first_id[1] * (dimension == 3 ? 9 : 5));
  }
}

TEST(Grid, FindsTheCellOfAPoint) {
  Grid grid = alone(1);
  EXPECT_TRUE(grid.holds({1.0, -2.0, 0.0}));
  EXPECT_FALSE(grid.holds({11.0, 0.0, 0.0}));
  const Cell cell = cell_of(grid, {1.0 + 9.2 * 0.5, -2.0 + 3.7 * 0.5, 0.0});
  EXPECT_EQ(cell.tile, 1);
  EXPECT_EQ(cell.inside, 3 * 8 + 1);
  grid.owner = {0, 7, 0, 0, 0, 0};
  EXPECT_EQ(owner_of(grid, {5.6, -0.1, 0.0}), 7);
}

TEST(Parcels, AreTilesUntilThereAreTooMany) {
  const Parcels tiles(2, {5, 3, 1}, 15);
  EXPECT_EQ(tiles.bits, 0);
  EXPECT_EQ(tiles.count(), 15U);
  for (int tile = 0; tile < 15; ++tile) EXPECT_EQ(tiles.holding(tile), tile);
}

TEST(Parcels, HoldTheTilesOfSquaresAndCubes) {
  const Parcels flat(2, {5, 3, 1}, 14), solid(3, {5, 3, 6}, 12);
  EXPECT_EQ(flat.bits, 1);
  EXPECT_EQ(flat.count(), 6U);  // 3 x 2
  EXPECT_EQ(solid.bits, 2);     // 3 x 2 x 3 were more than 12
  EXPECT_EQ(solid.count(), 4U);
  for (int z = 0; z < 6; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) {
        if (z == 0) {
          EXPECT_EQ(flat.holding(y * 5 + x), y / 2 * 3 + x / 2);
        }
        EXPECT_EQ(solid.holding((z * 3 + y) * 5 + x), z / 4 * 2 + x / 4);
      }
}

TEST(Parcels, AreNotDealtOutWhereARankCannotCountItsParticles) {
  Grid grid = alone(1);
  std::vector<ParcelCost> particles(6);
  for (ParcelCost& parcel : particles) parcel.particles = 3e8;
  EXPECT_NO_THROW(share_parcels(particles, grid));
  for (ParcelCost& parcel : particles) parcel.particles = 4e8;
  EXPECT_THROW(share_parcels(particles, grid), DeckError);
}

TEST(Parcels, SayWhoOwnsTheirTiles) {
  Scene scene = scene_of_six_tiles();
  scene.grid.most_parcels = 2;
  Grid grid = make_grid(scene, 1, Teuchos::rcp(new Teuchos::SerialComm<int>));
  EXPECT_EQ(grid.owner.size(), 2U);
  set_owners({0, 7}, grid);
  for (int tile = 0; tile < 6; ++tile) {
    EXPECT_EQ(owner_of(grid, tile), tile % 3 == 2 ? 7 : 0) << tile;
    EXPECT_EQ(grid.owner_of_tile(tile), owner_of(grid, tile)) << tile;
  }
}

/// What a rank keeps of a box hardly grows with it: 1.6e9 tiles, of which two are active.
TEST(TileDirectory, FindsFewTilesInAVastBox) {
  Scene scene;
  scene.grid = {Mode::plane_strain, {0.0, 0.0, 0.0}, {320000.0, 320000.0, 0.0}, 1.0, {}};
  Grid grid = make_grid(scene, 1, Teuchos::rcp(new Teuchos::SerialComm<int>));
  constexpr int tiles = 40000 * 40000;
  ASSERT_EQ(grid.box.first_id[1], tiles);
  EXPECT_LE(grid.owner.size(), scene.grid.most_parcels);
  EXPECT_LT(grid.directory.begin.span(), 6.3e6);
  activate_tiles(grid, {40001, tiles - 1});
  EXPECT_EQ(grid.directory(40001), 0);
  EXPECT_EQ(grid.directory(tiles - 1), 1);
  EXPECT_EQ(grid.directory(40002), -1);
  EXPECT_EQ(grid.directory(0), -1);
  EXPECT_EQ(grid.tile_frame(0).position[1], 1);
  activate_tiles(grid, {7});
  EXPECT_EQ(grid.directory(7), 0);
  EXPECT_EQ(grid.directory(40001), -1);
  EXPECT_EQ(grid.directory(tiles - 1), -1);
}

TEST(Tiles, CountEveryNodeOnce) {
  Grid grid = alone(1);
  activate_tiles(grid, {0, 1, 3});
  EXPECT_EQ(grid.active, 3);
  EXPECT_EQ(grid.ghosts, 0);
  EXPECT_EQ(grid.directory(3), 2);
  EXPECT_EQ(grid.directory(2), -1);
  EXPECT_EQ(grid.neighbours(0 * 9 + 5), 1);  // along +x
  EXPECT_EQ(grid.neighbours(0 * 9 + 7), 2);  // along +y
  EXPECT_EQ(grid.neighbours(1 * 9 + 5), -1);
  int counted = 0;
  for (int i = 0; i < 3 * 121; ++i) counted += grid.counts(i);
  // Tiles 0 and 1 reach 19 x 11 nodes, tile 3 above the first 11 x 8 more.
  EXPECT_EQ(counted, 19 * 11 + 11 * 8);
  activate_tiles(grid, {3});
  EXPECT_EQ(grid.directory(0), -1);
  EXPECT_EQ(grid.activations, 2);
}

TEST(Tiles, TakeCellSizeAndStepIntoTheirFrames) {
  Grid grid = alone(1);
  activate_tiles(grid, {1, 4});
  set_tile_steps(grid, 2.5e-7);
  for (int t = 0; t < 2; ++t) {
    const TileFrame& frame = grid.tile_frame(t);
    EXPECT_EQ(frame.cell_size, 0.5);
    EXPECT_EQ(frame.dt, 2.5e-7);
    EXPECT_EQ(frame.position[0], 1);
    EXPECT_EQ(frame.position[1], t);
  }
}

TEST(Halo, BringsTheValuesOfTilesFromTheirOwners) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  Grid grid = make_grid(scene_of_six_tiles(), 1, comm);
  const int ranks = comm->getSize(), rank = comm->getRank();
  std::vector<int> owned;
  for (int tile = 0; tile < 6; ++tile) {
    grid.owner[static_cast<std::size_t>(tile)] = tile % ranks;
    if (tile % ranks == rank) owned.push_back(tile);
  }
  activate_tiles(grid, owned);
  EXPECT_EQ(grid.active, static_cast<int>(owned.size()));
  EXPECT_EQ(grid.ghosts, ranks == 1 ? 0 : 3);  // of two ranks: all tiles touch here
  constexpr int width = 2;
  const auto tile_of = [&](int t) {
    const TilePosition& at = grid.tile_frame(t).position;
    return grid.box.id(at);
  };
  const ArrayView<double> sums(
      "sums", static_cast<std::size_t>((grid.active + grid.ghosts) * width)
  );
  for (int t = 0; t < grid.active; ++t)
    for (int c = 0; c < width; ++c) sums(t * width + c) = 10.0 * tile_of(t) + c;
  exchange_tiles(grid, sums, width);
  for (int t = 0; t < grid.active + grid.ghosts; ++t)
    for (int c = 0; c < width; ++c) EXPECT_EQ(sums(t * width + c), 10.0 * tile_of(t) + c);
}

/// Of a ghost's nodes those come that one of the own patches holds too, and no others.
TEST(Halo, BringsTheSumsOfSharedNodesFromTheirOwners) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  Grid grid = make_grid(scene_of_six_tiles(), 1, comm);
  const int ranks = comm->getSize(), rank = comm->getRank(), size = grid.patch.size;
  std::vector<int> owned;
  for (int tile = 0; tile < 6; ++tile) {  // columns: the first is the first rank's
    grid.owner[static_cast<std::size_t>(tile)] = tile % 3 == 0 ? 0 : ranks - 1;
    if (grid.owner[static_cast<std::size_t>(tile)] == rank && tile != 3) owned.push_back(tile);
  }
  activate_tiles(grid, owned);
  constexpr int components = 2;
  constexpr double untouched = -1.0;
  const auto value = [&](int tile, int slot, int c) { return 1000.0 * tile + slot + 0.5 * c; };
  const auto first = [&](int t, int slot) { return (t * size + slot) * components; };
  const int local = grid.active + grid.ghosts;
  const ArrayView<double> sums("sums", static_cast<std::size_t>(first(local, 0)));
  Kokkos::deep_copy(sums, untouched);
  const auto tile_of = [&](int t) { return grid.box.id(grid.tile_frame(t).position); };
  for (int t = 0; t < grid.active; ++t)
    for (int slot = 0; slot < size; ++slot)
      for (int c = 0; c < components; ++c) sums(first(t, slot) + c) = value(tile_of(t), slot, c);
  exchange_halo(grid, sums, components);
  int fetched = 0;
  for (int t = grid.active; t < local; ++t)
    for (int slot = 0; slot < size; ++slot) {
      const bool shared = grid.fetched((t - grid.active) * size + slot) != 0;
      fetched += shared ? 1 : 0;
      for (int c = 0; c < components; ++c)
        EXPECT_EQ(sums(first(t, slot) + c), shared ? value(tile_of(t), slot, c) : untouched);
    }
  // Patches have 11 x 11 nodes and neighbours 3 columns in common: of tile 0 all those at tile 1,
  // which its corner with tile 4 is a part of; of tile 1 the same, of tile 4 three by three.
  if (ranks == 2) {
    EXPECT_EQ(fetched, rank == 0 ? 3 * 11 + 3 * 3 : 3 * 11);
  }
}

/// Half of the tiles are active, and change: only those that touch are exchanged, each by its
/// owner.
TEST(Halo, KnowsWhichTilesOfOthersAreActive) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  Scene scene;
  scene.grid = {Mode::plane_strain, {0.0, 0.0, 0.0}, {80.0, 80.0, 0.0}, 1.0};  // 10 x 10 tiles
  Grid grid = make_grid(scene, 1, comm);
  const int ranks = comm->getSize(), rank = comm->getRank();
  for (int tile = 0; tile < 100; ++tile)
    grid.owner[static_cast<std::size_t>(tile)] = tile % 10 * ranks / 10;
  for (const int part : {0, 1, 2}) {
    const auto is_active = [&](int tile) { return (tile / 10 + tile) % 3 == part; };
    std::vector<int> owned, ghosts;
    for (int tile = 0; tile < 100; ++tile)
      if (is_active(tile) && grid.owner[static_cast<std::size_t>(tile)] == rank)
        owned.push_back(tile);
    for (int tile = 0; tile < 100; ++tile) {
      if (!is_active(tile) || grid.owner[static_cast<std::size_t>(tile)] == rank) continue;
      for (const int mine : owned)
        if (std::abs(mine / 10 - tile / 10) <= 1 && std::abs(mine % 10 - tile % 10) <= 1) {
          ghosts.push_back(tile);
          break;
        }
    }
    activate_tiles(grid, owned);
    ASSERT_EQ(grid.active, static_cast<int>(owned.size()));
    ASSERT_EQ(grid.ghosts, static_cast<int>(ghosts.size()));
    std::vector<int> local = owned;
    local.insert(local.end(), ghosts.begin(), ghosts.end());
    const ArrayView<double> sums("sums", local.size());
    for (std::size_t t = 0; t < owned.size(); ++t) sums(t) = 0.5 * owned[t];
    exchange_tiles(grid, sums, 1);
    for (std::size_t t = 0; t < local.size(); ++t) EXPECT_EQ(sums(t), 0.5 * local[t]);
    for (int tile = 0; tile < 100; ++tile) {
      const auto found = std::find(local.begin(), local.end(), tile);
      const int place = found == local.end() ? -1 : static_cast<int>(found - local.begin());
      EXPECT_EQ(grid.directory(tile), place) << tile;
    }
  }
}

TEST(Migrate, SendsRowsToTheRanksNamed) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const int ranks = comm->getSize(), rank = comm->getRank();
  std::vector<std::vector<double>> outgoing(static_cast<std::size_t>(ranks));
  for (int to = 0; to < ranks; ++to)
    for (int i = 0; i <= rank; ++i)
      outgoing[static_cast<std::size_t>(to)].push_back(100.0 * rank + 10.0 * to + i);
  const std::vector<double> received = exchange_rows(*comm, outgoing);
  std::vector<double> wanted;
  for (int from = 0; from < ranks; ++from)
    for (int i = 0; i <= from; ++i) wanted.push_back(100.0 * from + 10.0 * rank + i);
  EXPECT_EQ(received, wanted);
}

}  // namespace
}  // namespace barreno
