// SPDX-License-Identifier: BSD-3-Clause
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "step/order/sort_by_cell.hpp"
#include "step/transfer/project_particles.hpp"
#include "support/scenes.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace barreno {
namespace {

/// A particle that fills a cell gives a quarter of what it has to each corner of the cell, where
/// the gradients are +-1/2 per cell size along each axis.
TEST(ProjectParticles, AParticleGivesToTheCornersOfItsCell) {
  const Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  State state = testing::start_in_tiles(scene);
  testing::set_frame(state.grid, 0, 1.0, 0.1);
  // Cells half as large: the tile's own are those from 4 to 8 along x.
  testing::set_frame(state.grid, 1, 0.5, 0.1);
  Particles& particles = state.particles[0];
  for (int tile = 0; tile < 2; ++tile) {
    const int p = testing::row_in(particles, tile);
    particles.velocity(p, 0) = 2.0;
    particles.velocity(p, 1) = 3.0 + tile;
    const double stress[] = {6.0, 5.0, 4.0, 7.0};
    for (int c = 0; c < 4; ++c) particles.stress(p, c) = stress[c];
    particles.viscous_pressure(p) = 1.0;
  }
  const int fine = testing::row_in(particles, 1);
  particles.position(fine, 0) = 4.0 + 3.5 * 0.5;
  particles.position(fine, 1) = 3.5 * 0.5;
  for (int d = 0; d < 2; ++d) particles.half_size(fine, d) = 0.25;

  Nodes& nodes = state.nodes[0];
  clear_nodes(state.grid, nodes);
  project_particles(state.grid, particles, nodes);
  for (int tile = 0; tile < 2; ++tile) {
    const double per_cell = tile == 0 ? 1.0 : 2.0;
    const double* const patch = &nodes.sums(first_sum(state.grid.patch, tile));
    double mass = 0.0;
    for (int slot = 0; slot < state.grid.patch.size; ++slot) mass += patch[slot * sum_components];
    EXPECT_EQ(mass, 4.0);
    for (const int x : {0, 1})
      for (const int y : {0, 1}) {
        const double gx = (x - 0.5) * per_cell, gy = (y - 0.5) * per_cell;
        const double* const node =
            patch + testing::slot_of(state.grid.patch, 3 + x, 3 + y) * sum_components;
        EXPECT_EQ(node[0], 1.0);
        EXPECT_EQ(node[1], 2.0);
        EXPECT_EQ(node[2], 3.0 + tile);
        EXPECT_EQ(node[3], -(5.0 * gx + 7.0 * gy));
        EXPECT_EQ(node[4], -(7.0 * gx + 4.0 * gy));
      }
  }
}

TEST(ProjectParticles, TilesThatKeepTheirSumsAreLeftAlone) {
  const Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  State state = testing::start_in_tiles(scene);
  Nodes& nodes = state.nodes[0];
  clear_nodes(state.grid, nodes);
  nodes.sums_kept = ArrayView<unsigned char>("sums_kept", 2);
  nodes.sums_kept(0) = 1;
  const int slot = testing::slot_of(state.grid.patch, 3, 3) * sum_components;
  nodes.sums(static_cast<std::size_t>(slot)) = 9.0;
  clear_nodes(state.grid, nodes);
  project_particles(state.grid, state.particles[0], nodes);
  EXPECT_EQ(nodes.sums(static_cast<std::size_t>(slot)), 9.0);
  EXPECT_EQ((&nodes.sums(first_sum(state.grid.patch, 1)))[slot], 1.0);
}

/// Puts every `rows_per_batch`-th row in the place of the one five further on; the particles of
/// tiles are still visited as before.
void exchange_rows(Particles& particles) {
  for (int p = 0; p + 5 < particles.count; p += rows_per_batch) {
    particles.for_each_field([&](Field& field) {
      for (int c = 0; c < field.components; ++c) std::swap(field(p, c), field(p + 5, c));
    });
    for (int k = 0; k < particles.count; ++k) {
      int& row = particles.order(k);
      row = row == p ? p + 5 : row == p + 5 ? p : row;
    }
  }
}

/// Bits must not depend on the rows that particles have, which ranks and restarts change: rows that
/// are neighbours have a loop of their own (for_each_row_of).
TEST(ProjectParticles, RowsOutOfOrderGiveTheSameBits) {
  for (const Mode mode : testing::all_modes)
    for_each_shape([&](auto shape) {
      const bool space = mode == Mode::three_dimensional;
      const double depth = space ? 0.004 : 0.0;
      Scene scene = testing::box_scene(
          mode, 1e-3, {0.0, 0.0, 0.0}, {0.012, 0.012, space ? 0.012 : 0.0}, testing::copper()
      );
      scene.step.shape = decltype(shape)::word;
      testing::add_box(scene, "block", {0.0, 0.003, depth}, {0.008, 0.007, 2.0 * depth}, 2);
      scene.bodies[0].velocity = {60.0, 60.0, space ? 60.0 : 0.0};
      scene.bodies[0].velocity_wave_number = {490.0, 250.0, 0.0};
      State state = testing::start_alone(scene);
      testing::advance_to(scene, 1.0, state, 5);
      Particles& particles = state.particles[0];
      Nodes& nodes = state.nodes[0];
      const auto project = [&] {
        clear_nodes(state.grid, nodes);
        project_particles(state.grid, particles, nodes);
        const double* const sums = &nodes.sums(0);
        return std::vector<double>(
            sums, sums + state.grid.active * state.grid.patch.size * sum_components
        );
      };
      sort_by_cell(state.grid, particles);
      permute_rows(particles);
      const std::vector<double> before = project();
      exchange_rows(particles);
      EXPECT_EQ(before, project()) << scene.step.shape;
    });
}

}  // namespace
}  // namespace barreno
