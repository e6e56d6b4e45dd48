// SPDX-License-Identifier: BSD-3-Clause
#include "check/awake_parts.hpp"
#include "check/body_steps.hpp"
#include "check/predict_cost.hpp"
#include "scene/tile_levels.hpp"
#include "state/bodies/body_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

/// The part of a body's particle-steps that dormant tiles do not skip.
double awake_share(const Scene& scene, const BodySpec& body, double dt) {
  double awake = 0.0, all = 0.0;
  for_each_awake_part(scene, body, dt, [&](const AwakePart& part) {
    awake += part.particles * part.awake;
    all += part.particles;
  });
  return awake / all;
}

/// Where motion spreads ahead of waves of 5657 m/s: (15)^2 c h in a unit of time, and as a wave
/// where that is faster, beyond 225 cells.
const double wave = std::sqrt(young / density), diffusivity = 225.0 * wave * cell;

TEST(AwakeParts, GrowsAsMotionSpreadsAheadOfWaves) {
  // A tenth of the bar, 200 cells. After the time t, sqrt(D t) is reached; the mean over the time
  // is two thirds of that.
  const double end_time = 4.0 / diffusivity;
  const Scene scene = bar_and_jet(end_time);
  EXPECT_NEAR(awake_share(scene, scene.bodies[0], 1e-6), 2.0 / 3.0 * 2.0 / length, 2e-3);
  const Scene shorter = bar_and_jet(end_time / 4.0);
  EXPECT_NEAR(awake_share(shorter, shorter.bodies[0], 1e-6), 2.0 / 3.0 * 1.0 / length, 2e-3);
}

TEST(AwakeParts, GrowsAsWavesRunFarFromTheJet) {
  const double half_way = 0.5 * length / wave;
  const Scene scene = bar_and_jet(half_way);
  // Half of the bar is reached, on average after half of the time.
  EXPECT_NEAR(awake_share(scene, scene.bodies[0], 1e-6), 0.25, 0.01);
  const Scene longer = bar_and_jet(8.0 * half_way);
  EXPECT_NEAR(awake_share(longer, longer.bodies[0], 1e-6), 1.0 - 0.125, 0.01);
}

TEST(AwakeParts, IsAllWhereABodyMovesOrNothingIsSkipped) {
  Scene scene = bar_and_jet(1e-4);
  EXPECT_LT(awake_share(scene, scene.bodies[0], 1e-6), 0.1);
  EXPECT_TRUE(foresees_dormancy(scene));
  scene.step.skip_dormant = false;
  EXPECT_EQ(awake_share(scene, scene.bodies[0], 1e-6), 1.0);
  scene.step.skip_dormant = true;
  scene.bodies[0].velocity = {0.0, 1.0, 0.0};
  EXPECT_EQ(awake_share(scene, scene.bodies[0], 1e-6), 1.0);
  scene.bodies[0].velocity = {};
  scene.jet.present = false;
  EXPECT_EQ(awake_share(scene, scene.bodies[0], 1e-6), 1.0);
  EXPECT_FALSE(foresees_dormancy(scene));
}

TEST(BodySteps, AreParticlesTimesTheTimeThatTheyAreAwake) {
  constexpr double dt = 1e-6;
  Scene scene = bar_and_jet(1.0);  // all are awake nearly always
  const double particles = length / cell * 10;
  BodySteps steps = steps_of_bodies(scene, particle_counts(scene), dt);
  EXPECT_NEAR(steps.all / (particles / dt), 1.0, 1e-12);
  EXPECT_NEAR(steps.awake / steps.all, 1.0, 0.01);
  EXPECT_EQ(steps.taken, steps.awake);  // one step for all
  // The lower half of the bar in cells of half the size: four times as many particles.
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {{Box{{0, -0.1, 0}, {0.2, 10, 0}}, 1}});
  steps = steps_of_bodies(scene, particle_counts(scene), dt);
  EXPECT_NEAR(steps.all / (2.5 * particles / dt), 1.0, 0.02);
  EXPECT_NEAR(steps.shares.of_level[0] / steps.taken, 0.2, 0.01);
  EXPECT_NEAR(steps.shares.of_level[1] / steps.taken, 0.8, 0.01);
  // The front has only come as far as to the border.
  scene.end_time = 10.0 / wave;
  steps = steps_of_bodies(scene, particle_counts(scene), dt);
  EXPECT_NEAR(steps.shares.of_level[1] / steps.taken, 1.0, 0.01);
}

/// Half of the bar shares its tiles with the jet, and takes all parts one by one; the other half as
/// many at once as it bears.
TEST(BodySteps, AreFewerWhereTilesTakeSeveralPartsAtOnce) {
  Scene scene = bar_and_jet(1.0);
  BodySpec& bar = scene.bodies[0];
  bar.shape = Box{{0, 0, 0}, {0.16, length, 0}};  // two tiles wide
  scene.step.skip_dormant = false;
  const double stable = stable_steps_of_materials(scene, true).front();
  scene.step.subcycles = 4;
  for (const auto& [parts, share] :
       {std::pair{1.5, 1.0}, std::pair{2.5, 0.75}, std::pair{9.0, 0.625}}) {
    const BodySteps steps = steps_of_bodies(scene, particle_counts(scene), stable / parts);
    EXPECT_NEAR(steps.awake / steps.all, 1.0, 1e-12);
    EXPECT_NEAR(steps.taken / steps.awake, share, 1e-12) << parts;
  }
  scene.step.subcycles = 2;
  const BodySteps steps = steps_of_bodies(scene, particle_counts(scene), stable / 9.0);
  EXPECT_NEAR(steps.shares.of_length[1] / steps.taken, 0.25 / 0.75, 1e-12);
}

}  // namespace
}  // namespace barreno
