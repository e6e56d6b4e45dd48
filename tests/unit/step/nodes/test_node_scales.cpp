// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/node_scales.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// A full cell of the densest material that crosses its cell in the step.
TEST(NodeScales, AreThoseOfAFullCellThatCrossesItself) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {8.0, 8.0, 0.0}, testing::elastic(1.0, 0.25, 2.0)
  );
  scene.materials.push_back(testing::elastic(1.0, 0.25, 16.0));
  const NodeScaleRule rule(scene.materials, scene.grid);
  const NodeScales scales = rule(0.5, 0.25);  // mass 16/4, speed 2
  EXPECT_EQ(scales.impulse.first, SplitScales(4.0 * 2.0).first);
  EXPECT_EQ(scales.energy.first, SplitScales(4.0 * 4.0).first);

  scene.grid.mode = Mode::axisymmetric;
  const NodeScales rings = NodeScaleRule(scene.materials, scene.grid)(0.5, 0.25);
  EXPECT_EQ(rings.impulse.top, SplitScales(4.0 * 2.0 * two_pi * 8.0).top);
}

/// What add_split gives is the number, and the same sum in every order.
TEST(AddSplit, PartsAddUpInAnyOrder) {
  const SplitScales scales(1.0);
  const double numbers[] = {0.1, -0.7, 1.0 / 3.0, 1e-9, 0.6180339887};
  double forth[2] = {}, back[2] = {}, whole = 0.0;
  for (int i = 0; i < 5; ++i) {
    add_split(numbers[i], scales, forth);
    add_split(numbers[4 - i], scales, back);
    whole += numbers[i];
  }
  EXPECT_EQ(forth[0], back[0]);
  EXPECT_EQ(forth[1], back[1]);
  EXPECT_NEAR(forth[0] + forth[1], whole, 1e-15);
}

}  // namespace
}  // namespace barreno
