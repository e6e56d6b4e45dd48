// SPDX-License-Identifier: BSD-3-Clause
// The order of rows by (tile, cell, id), however they are stored.
#include "step/order/sort_by_cell.hpp"
#include "step/ranks/place_particles.hpp"
#include "unit/step/order/four_particles.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <tuple>
#include <vector>

namespace barreno {
namespace {

/// Sixteen particles in tile 0 and its neighbour along x, several in a cell.
State shuffled(int stride) {
  Scene scene = testing::four_particles();
  scene.bodies[0].shape = Box{{6.0, 0.0}, {10.0, 4.0}};
  State state = testing::start_alone(scene);
  Particles& particles = state.particles[0];
  for (int row = 0; row < particles.count; ++row) {
    const int k = row * stride % particles.count;  // which particle is stored here
    particles.id(row) = 100 - k;
    testing::put(particles, row, 7.2 + 0.1 * (k % 16), 0.5 + 2.0 * (k % 3));
  }
  locate_particles(continuum_of(state));
  place_particles({false, true}, 1, continuum_of(state));
  return state;
}

std::vector<ParticleId> sorted_ids(const Particles& particles) {
  std::vector<ParticleId> ids;
  ids.reserve(static_cast<std::size_t>(particles.count));
  for (int k = 0; k < particles.count; ++k) ids.push_back(particles.id(particles.order(k)));
  return ids;
}

TEST(SortByCell, RowsAreByTileCellAndId) {
  State state = shuffled(7);
  Particles& particles = state.particles[0];
  ASSERT_EQ(particles.count, 16);
  sort_by_cell(state.grid, particles);
  EXPECT_TRUE(particles.sorted);
  using Place = std::tuple<int, ParticleId>;
  int in_same_cell = 0;
  for (int k = 1; k < particles.count; ++k) {
    const int before = particles.order(k - 1), row = particles.order(k);
    const Place a{index_of(particles.key(before)), particles.id(before)};
    const Place b{index_of(particles.key(row)), particles.id(row)};
    EXPECT_LT(a, b);
    if (std::get<0>(a) == std::get<0>(b)) ++in_same_cell;
  }
  EXPECT_GE(in_same_cell, 8);
  // x >= 8 from the eighth on: eight particles in each tile.
  EXPECT_EQ(particles.tile_begin(0), 0);
  EXPECT_EQ(particles.tile_begin(1), 8);
  EXPECT_EQ(particles.tile_begin(2), 16);
}

TEST(SortByCell, TheOrderDoesNotDependOnTheStorage) {
  const std::vector<ParticleId> ids = sorted_ids(shuffled(1).particles[0]);
  for (const int stride : {3, 5, 7, 15}) EXPECT_EQ(sorted_ids(shuffled(stride).particles[0]), ids);
}

TEST(SortByCell, PermutedRowsAreStoredInTheirOrder) {
  State state = shuffled(11);
  Particles& particles = state.particles[0];
  const std::vector<ParticleId> ids = sorted_ids(particles);
  const double x = particles.position(particles.order(3), 0);
  permute_rows(particles);
  for (int k = 0; k < particles.count; ++k) {
    EXPECT_EQ(particles.order(k), k);
    EXPECT_EQ(particles.id(k), ids[static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(particles.position(3, 0), x);
}

}  // namespace
}  // namespace barreno
