// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "state/bodies/body_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

/// A quarter of a hollow ball in cells of size h, centre in the corner of the grid.
Scene quarter(Mode mode, double h, int particles_per_cell) {
  Scene scene =
      testing::box_scene(mode, h, {}, {40.0 * h, 40.0 * h, 0.0}, testing::elastic(1e9, 0.3, 1e3));
  BodySpec body;
  body.name = "Shell";
  body.shape = Ball{{}, 34.2 * h, 19.7 * h};
  body.particles_per_cell = particles_per_cell;
  body.radial_velocity = -3.0;
  scene.bodies.push_back(body);
  return scene;
}

TEST(HollowBall, HasTheVolumeOfTheSphereExactlyAndNoSlivers) {
  for (const int per_cell : {1, 2, 3}) {
    constexpr double h = 1e-3;
    const Scene scene = quarter(Mode::axisymmetric, h, per_cell);
    double volume = 0.0, smallest = 1.0;
    long long count = 0;
    for_each_body_particle(scene.grid, scene.bodies[0], 1, [&](const NewParticle& p) {
      volume += p.volume;
      smallest = std::min(smallest, p.volume / (8.0 * pi * p.x[0] * p.half[0] * p.half[1]));
      ++count;
    });
    const double exact = 2.0 * pi / 3.0 * (std::pow(34.2 * h, 3) - std::pow(19.7 * h, 3));
    EXPECT_NEAR(volume / exact, 1.0, 1e-12);
    EXPECT_GE(smallest, 0.24);
    EXPECT_EQ(count, count_body_particles(scene.grid, scene.bodies[0]));
  }
}

TEST(HollowBall, LeavesRoomInItsHollow) {
  const GridSpec grid{Mode::plane_strain, {-10.0, -10.0, 0.0}, {10.0, 10.0, 0.0}, 1.0};
  const Shape shell = Ball{{0.0, 0.0, 0.0}, 5.0, 3.0};
  EXPECT_FALSE(overlap(shell, Ball{{0.0, 0.0, 0.0}, 3.0}, grid, 1.0));
  EXPECT_FALSE(overlap(Ball{{1.0, 0.0, 0.0}, 1.9}, shell, grid, 1.0));
  EXPECT_TRUE(overlap(shell, Ball{{1.5, 0.0, 0.0}, 1.9}, grid, 1.0));
  EXPECT_FALSE(overlap(shell, Box{{-2.0, -2.0, 0.0}, {2.0, 2.0, 0.0}}, grid, 1.0));
  EXPECT_TRUE(overlap(shell, Box{{-2.0, -2.0, 0.0}, {2.5, 2.0, 0.0}}, grid, 1.0));
  EXPECT_TRUE(overlap(shell, Box{{2.0, -1.0, 0.0}, {4.0, 1.0, 0.0}}, grid, 1.0));
  EXPECT_TRUE(
      overlap(Ball{{0.0, 0.0, 0.0}, 3.0}, Box{{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}}, grid, 1.0)
  );
}

TEST(HollowBall, HasTheAreaOfTheDiskInPlaneStrain) {
  const Scene scene = quarter(Mode::plane_strain, 1e-3, 2);
  double area = 0.0;
  for_each_body_particle(scene.grid, scene.bodies[0], 1, [&](const NewParticle& p) {
    area += p.volume;
  });
  EXPECT_NEAR(area / (0.25 * pi * (34.2 * 34.2 - 19.7 * 19.7) * 1e-6), 1.0, 1e-12);
}

TEST(HollowBall, StartsWithTheVelocityThatKeepsVolumes) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain}) {
    const Scene scene = quarter(mode, 1e-3, 2);
    for (const auto& row : testing::all_rows(testing::start_alone(scene))) {
      const double r = std::hypot(row[0], row[1]), ratio = 19.7e-3 / r;
      const double speed = -3.0 * (mode == Mode::axisymmetric ? ratio * ratio : ratio);
      EXPECT_NEAR(row[2], speed * row[0] / r, 1e-12);
      EXPECT_NEAR(row[3], speed * row[1] / r, 1e-12);
    }
  }
}

}  // namespace
}  // namespace barreno
