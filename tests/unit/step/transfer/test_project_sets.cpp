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

/// Nodes behind a symmetry plane add their sums to their images, with the normal components
/// reversed.
TEST(SumHalos, NodesBeyondAMirrorGiveToTheirImages) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {8.0, 8.0, 0.0}, testing::elastic(1.0, 0.25, 4.0)
  );
  testing::add_box(scene, "at the wall", {0.0, 3.0, 0.0}, {1.0, 4.0, 0.0}, 1);
  scene.bodies[0].velocity = {1.0, 2.0, 0.0};
  testing::add_symmetry(scene, Face::x_lower);
  State state = testing::start_in_tiles(scene);
  // Half a cell to the left of its cell's middle: an eighth of it is at each node beyond.
  state.particles[0].position(0, 0) = 0.0;
  project_sets(state.grid, state.particles, state.nodes, state.effort);
  const auto value = [&](int x, int component) {
    return state.nodes[0].sums(static_cast<std::size_t>(
        testing::slot_of(state.grid.patch, x, 3) * sum_components + component
    ));
  };
  const double beyond = value(-1, 0), image = value(1, 0);
  ASSERT_EQ(beyond, 4.0 / 16.0);
  sum_halos(SymmetryPlanes(scene.conditions, state.grid), state.grid, state.nodes);
  EXPECT_EQ(value(1, 0), image + beyond);
  EXPECT_EQ(value(1, 1), image - beyond);
  EXPECT_EQ(value(1, 2), 2.0 * (image + beyond));
  EXPECT_EQ(value(-1, 0), 0.0);
}

}  // namespace
}  // namespace barreno
