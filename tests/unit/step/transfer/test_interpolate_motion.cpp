// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/interpolate_motion.hpp"
#include "step/transfer/project_particles.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

/// v = v0 + G x and dv = 2 (v - v0) at the nodes, x in cells from the tile's first node.
constexpr double v0[] = {1.0, -2.0};
constexpr double slope[2][2] = {{0.5, 0.25}, {-1.0, 0.125}};

void set_linear_motion(const Grid& grid, const Nodes& nodes) {
  for (int tile = 0; tile < grid.active; ++tile)
    for (int slot = 0; slot < grid.patch.size; ++slot) {
      int at[2];
      position_of_slot(grid.patch, slot, at);
      double* const node =
          &nodes.motion(first_motion(grid.patch, tile)) + slot * motion_components(2);
      for (int i = 0; i < 2; ++i) {
        const double rise =
            slope[i][0] * (at[0] - grid.patch.reach) + slope[i][1] * (at[1] - grid.patch.reach);
        node[i] = v0[i] + rise;
        node[2 + i] = 2.0 * rise;
      }
    }
}

/// Weights add up to one and reproduce linear fields: velocities are those at the particle, and
/// dt L is the slope over the tile's cell size times the tile's step.
TEST(InterpolateMotion, LinearFieldsAreExactWithTheFrameOfTheTile) {
  const Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  State state = testing::start_in_tiles(scene);
  testing::set_frame(state.grid, 0, 1.0, 0.5);
  testing::set_frame(state.grid, 1, 0.5, 0.125);
  Particles& particles = state.particles[0];
  const int fine = testing::row_in(particles, 1);
  particles.position(fine, 0) = 4.0 + 3.5 * 0.5;
  particles.position(fine, 1) = 3.5 * 0.5;
  for (int d = 0; d < 2; ++d) particles.half_size(fine, d) = 0.25;
  Nodes& nodes = state.nodes[0];
  clear_nodes(state.grid, nodes);
  set_linear_motion(state.grid, nodes);
  const double largest = interpolate_motion(state.grid, {}, {}, nodes, particles);
  for (int tile = 0; tile < 2; ++tile) {
    const int p = testing::row_in(particles, tile);
    const double factor = tile == 0 ? 0.5 : 0.125 / 0.5;  // dt / h
    for (int i = 0; i < 2; ++i) {
      const double rise = 3.5 * (slope[i][0] + slope[i][1]);
      EXPECT_EQ(particles.grid_motion(p, i), v0[i] + rise);
      EXPECT_EQ(particles.grid_motion(p, 2 + i), 2.0 * rise);
      for (int d = 0; d < 2; ++d)
        EXPECT_EQ(particles.increment(p, 2 * i + d), factor * slope[i][d]);
    }
    EXPECT_EQ(particles.increment(p, 4), 0.0);
  }
  const double shear = slope[0][1] + slope[1][0];
  EXPECT_DOUBLE_EQ(
      largest,
      0.5 * std::sqrt(slope[0][0] * slope[0][0] + slope[1][1] * slope[1][1] + 0.5 * shear * shear)
  );
}

TEST(InterpolateMotion, DormantTilesMoveByNothing) {
  const Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  State state = testing::start_in_tiles(scene);
  for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.5);
  Dormancy dormancy;
  dormancy.on = true;
  dormancy.stays = ArrayView<unsigned char>("stays", 2);
  dormancy.stays(1) = is_dormant_tile;
  Particles& particles = state.particles[0];
  particles.chunk_part(0) = part_of_chunk;
  Nodes& nodes = state.nodes[0];
  clear_nodes(state.grid, nodes);
  set_linear_motion(state.grid, nodes);
  for (int p = 0; p < 2; ++p) particles.grid_motion(p, 0) = 7.0;
  interpolate_motion(state.grid, dormancy, {}, nodes, particles);
  EXPECT_EQ(particles.grid_motion(testing::row_in(particles, 0), 0), 1.0 + 3.5 * 0.75);
  EXPECT_EQ(particles.grid_motion(testing::row_in(particles, 1), 0), 0.0);
}

}  // namespace
}  // namespace barreno
