// SPDX-License-Identifier: BSD-3-Clause
#include "check/awake_share.hpp"
#include "scene/tile_levels.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

constexpr double young = 8e10, density = 2500.0, cell = 0.01, length = 20.0;

/// A long bar of 20 by 0.1, at the lower end of which a jet arrives at once.
Scene bar_and_jet(double end_time) {
  const MaterialSpec material = testing::elastic(young, 0.0, density);
  Scene scene =
      testing::box_scene(Mode::plane_strain, cell, {0, -0.1, 0}, {0.2, length, 0}, material);
  testing::add_box(scene, "bar", {0, 0, 0}, {0.1, length, 0}, 1);
  scene.bodies[0].initial_pressure = 1e6;
  scene.jet.present = true;
  scene.jet.launch_position = -1e-6;
  scene.jet.slugs.push_back({0.0, 1e4, 0.01, 0.01, density});
  scene.step.skip_dormant = true;
  scene.end_time = end_time;
  return scene;
}

TEST(AwakeShare, GrowsAsTheFrontRuns) {
  // The front runs ahead of waves of 5657 m/s: at three times their speed in the plane.
  const double front = 3.0 * std::sqrt(young / density);
  const double half_way = 0.5 * length / front;
  const Scene scene = bar_and_jet(half_way);
  // Half of the bar is reached, on average after half of the time.
  EXPECT_NEAR(awake_share(scene, scene.bodies[0], 1e-6), 0.25, 0.01);
  const Scene longer = bar_and_jet(8.0 * half_way);
  EXPECT_NEAR(awake_share(longer, longer.bodies[0], 1e-6), 1.0 - 0.125, 0.01);
}

TEST(AwakeShare, IsAllWhereABodyMovesOrNothingIsSkipped) {
  Scene scene = bar_and_jet(1e-4);
  EXPECT_LT(awake_share(scene, scene.bodies[0], 1e-6), 0.1);
  scene.step.skip_dormant = false;
  EXPECT_EQ(awake_share(scene, scene.bodies[0], 1e-6), 1.0);
  scene.step.skip_dormant = true;
  scene.bodies[0].velocity = {0.0, 1.0, 0.0};
  EXPECT_EQ(awake_share(scene, scene.bodies[0], 1e-6), 1.0);
  scene.bodies[0].velocity = {};
  scene.jet.present = false;
  EXPECT_EQ(awake_share(scene, scene.bodies[0], 1e-6), 1.0);
}

TEST(StepsByLevel, AreParticlesTimesTheTimeThatTheyAreAwake) {
  Scene scene = bar_and_jet(1.0);  // all are awake nearly always
  EXPECT_TRUE(steps_by_level(scene, 1e-6).empty());
  // The lower half of the bar in cells of half the size: four times as many particles.
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {{Box{{0, -0.1, 0}, {0.2, 10, 0}}, 1}});
  const std::vector<double> all = steps_by_level(scene, 1e-6);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0], 0.2, 0.01);
  EXPECT_NEAR(all[1], 0.8, 0.01);
  // The front has only come as far as to the border.
  scene.end_time = 10.0 / (3.0 * std::sqrt(young / density));
  EXPECT_NEAR(steps_by_level(scene, 1e-6)[1], 1.0, 0.01);
}

}  // namespace
}  // namespace barreno
