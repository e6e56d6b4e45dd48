// SPDX-License-Identifier: BSD-3-Clause
// Nodes behind a plane of symmetry and their images, one by one.
#include "step/boundary/mirror_nodes.hpp"
#include "unit/step/boundary/two_tiles_along_y.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::motion_at;
using testing::sums_at;

void put(double* sums, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) sums[i] = values[i];
}
void expect(const double* sums, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(sums[i], values[i]) << i;
}

TEST(MirrorSums, AnImageTakesWhatTheNodeBehindThePlaneGot) {
  const Scene scene = testing::two_tiles_along_y({Face::x_lower});
  State state = testing::in_tiles(scene, 1.0);
  put(sums_at(state, 0, 0, {-1, 3}), {2.0, 3.0, 5.0, 7.0, 11.0, 0.0, 0.0, 13.0});
  put(sums_at(state, 0, 0, {1, 3}), {20.0, 30.0, 50.0, 70.0, 110.0, 0.0, 0.0, 130.0});
  put(sums_at(state, 0, 0, {0, 3}), {1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 0.0, 6.0});
  const SymmetryPlanes planes(scene.conditions, state.grid);
  mirror_sums(planes, state.grid, state.nodes[0]);
  expect(sums_at(state, 0, 0, {1, 3}), {22.0, 27.0, 55.0, 63.0, 121.0, 0.0, 0.0, 143.0});
  expect(sums_at(state, 0, 0, {-1, 3}), std::vector<double>(8, 0.0));
  // A node on the plane is its own image.
  expect(sums_at(state, 0, 0, {0, 3}), {1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 0.0, 6.0});
}

TEST(MirrorSums, BehindAnEdgeTheImageIsThatOfBothPlanes) {
  const Scene scene = testing::two_tiles_along_y({Face::x_lower, Face::y_lower});
  State state = testing::in_tiles(scene, 1.0);
  put(sums_at(state, 0, 0, {-1, -1}), {2.0, 3.0, 5.0, 7.0, 11.0});
  const SymmetryPlanes planes(scene.conditions, state.grid);
  mirror_sums(planes, state.grid, state.nodes[0]);
  expect(sums_at(state, 0, 0, {1, 1}), {2.0, -3.0, -5.0, -7.0, -11.0});
  expect(sums_at(state, 0, 0, {-1, 1}), {0.0, 0.0, 0.0, 0.0, 0.0});
  // Behind a plane across y its mass stays, where the impedance was, for the balance of momentum.
  expect(sums_at(state, 0, 0, {1, -1}), {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0});
  EXPECT_EQ(state.nodes[0].mirrored(0), 5.0);
  EXPECT_EQ(state.nodes[0].mirrored(1), 11.0);
}

/// One node behind a plane across y, of mass 2; velocity (1, 3) of its image after an increment of
/// (0.25, 0.5); momentum 5 and force 11 along y of what was behind it.
GridTally mirror_one_node(const State& state, const Scene& scene, int tile) {
  const SymmetryPlanes planes(scene.conditions, state.grid);
  Nodes nodes = state.nodes[0];
  mirror_sums(planes, state.grid, nodes);
  const int bottom = state.grid.tile_frame(tile).position[1] == 0 ? 0 : 16;
  const int behind = bottom == 0 ? -1 : 17, image = bottom == 0 ? 1 : 15;
  sums_at(state, 0, tile, {4, behind})[impedance_component] = 2.0;
  nodes.mirrored(2 * static_cast<std::size_t>(tile)) = 5.0;
  nodes.mirrored(2 * static_cast<std::size_t>(tile) + 1) = 11.0;
  put(motion_at(state, 0, tile, {4, image}), {1.0, 3.0, 0.25, 0.5});
  GridTally tally;
  StepSpec step;
  step.pic_fraction = 0.25;
  mirror_velocities(planes, state.grid, GridShare(step), nodes, tally);
  expect(motion_at(state, 0, tile, {4, behind}), {1.0, -3.0, 0.25, -0.5});
  return tally;
}

TEST(MirrorVelocities, MirrorsMotionsAndTalliesTheImpulsesOfTheMirror) {
  const Scene scene = testing::two_tiles_along_y({Face::y_lower, Face::y_upper});
  const State state = testing::in_tiles(scene, 0.5);
  const GridTally tally = mirror_one_node(state, scene, 0);
  EXPECT_EQ(tally.condition_impulse.value(), -2.0 * 2.0 * 0.5 - 2.0 * 0.5 * 11.0);
  EXPECT_EQ(tally.filter_impulse.value(), -2.0 * 2.0 * 2.5 - 2.0 * 5.0);
  EXPECT_EQ(tally.taken_impulse.value(), 0.25 * (-2.0 * 2.0 * 2.5 - 2.0 * 5.0));
}

TEST(MirrorVelocities, EveryTileTakesItsOwnStep) {
  const Scene scene = testing::two_tiles_along_y({Face::y_lower, Face::y_upper});
  for (int tile = 0; tile < 2; ++tile) {
    const State mixed = testing::in_tiles(scene, 0.5);
    testing::set_tile_step(mixed.grid, 1, 0.125);
    const State alone = testing::in_tiles(scene, tile == 0 ? 0.5 : 0.125);
    EXPECT_EQ(
        mirror_one_node(mixed, scene, tile).condition_impulse.value(),
        mirror_one_node(alone, scene, tile).condition_impulse.value()
    );
  }
}

}  // namespace
}  // namespace barreno
