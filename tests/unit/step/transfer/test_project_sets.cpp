// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/project_sets.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

double total(const Grid& grid, const Nodes& nodes, int component) {
  double sum = 0.0;
  for (int tile = 0; tile < grid.active; ++tile)
    for (int slot = 0; slot < grid.patch.size; ++slot)
      sum += (&nodes.sums(first_sum(grid.patch, tile)))[slot * sum_components + component];
  return sum;
}

/// Two materials of one velocity field, in one cell each, moving apart.
Scene two_materials() {
  Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
  scene.materials.push_back(testing::elastic(1.0, 0.25, 2.0));
  scene.bodies[1].material = 1;
  scene.bodies[0].velocity = {1.0, 2.0, 0.0};
  scene.bodies[1].velocity = {-3.0, 2.0, 0.0};
  return scene;
}

TEST(ProjectSets, SetsOfOneFieldMeetOnItsNodes) {
  State state = testing::start_in_tiles(two_materials());
  project_sets(state.grid, state.particles, state.nodes, state.effort);
  ASSERT_EQ(state.nodes.size(), 1U);
  EXPECT_EQ(total(state.grid, state.nodes[0], 0), 4.0 + 2.0);
  EXPECT_EQ(total(state.grid, state.nodes[0], 1), 4.0 - 6.0);
  EXPECT_EQ(total(state.grid, state.nodes[0], 2), 8.0 + 4.0);
  project_sets(state.grid, state.particles, state.nodes, state.effort);
  EXPECT_EQ(total(state.grid, state.nodes[0], 0), 6.0);  // afresh
}

TEST(DropForces, MassAndMomentumStay) {
  State state = testing::start_in_tiles(two_materials());
  for (Particles& particles : state.particles) particles.stress(0, 0) = 5.0;
  project_sets(state.grid, state.particles, state.nodes, state.effort);
  const std::size_t corner =
      static_cast<std::size_t>(testing::slot_of(state.grid.patch, 3, 3)) * sum_components;
  const ArrayView<double>& sums = state.nodes[0].sums;
  ASSERT_EQ(sums(corner + 3), 2.5);
  drop_forces(state.grid, state.nodes);
  EXPECT_EQ(sums(corner), 1.0);
  EXPECT_EQ(sums(corner + 1), 1.0);
  EXPECT_EQ(sums(corner + 2), 2.0);
  for (std::size_t i = 3; i < sum_components; ++i) EXPECT_EQ(sums(corner + i), 0.0);
}

}  // namespace
}  // namespace barreno
