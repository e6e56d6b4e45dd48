// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/sum_halos.hpp"
#include "step/transfer/project_sets.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

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
