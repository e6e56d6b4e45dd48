// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/update_deformation.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

/// One particle with a given dt L, deformed by one step.
struct Deformed {
  Scene scene;
  State state;
  Particles& particles;

  explicit Deformed(Mode mode)
      : scene(one_particle(mode)),
        state(testing::start_in_tiles(scene)),
        particles(state.particles[0]) {}

  static Scene one_particle(Mode mode) {
    const double depth = mode == Mode::three_dimensional ? 8.0 : 0.0;
    Scene scene = testing::box_scene(
        mode, 1.0, {0.0, 0.0, 0.0}, {8.0, 8.0, depth}, testing::elastic(1.0, 0.25, 1.0)
    );
    testing::add_box(scene, "cube", {3.0, 3.0, 3.0}, {4.0, 4.0, 4.0}, 1);
    return scene;
  }
  /// @param gradient  dt L, rows first
  void by(const std::vector<double>& gradient, Gradient at = Gradient::at_start) {
    for (std::size_t c = 0; c < gradient.size(); ++c)
      particles.increment(0, static_cast<int>(c)) = gradient[c];
    update_deformation(scene.grid.mode, testing::all_rows_of(particles), at, particles);
  }
};

/// Of a stretch by e along one axis: its generator is that of f = 1 + e with half its square added
/// or, at the end of a step, of f = 1 / (1 - e) with half its square taken off.
double generator_of(double e, Gradient at) {
  if (at == Gradient::at_start) return std::log1p(e) + 0.5 * std::log1p(e) * std::log1p(e);
  return -std::log1p(-e) - 0.5 * std::log1p(-e) * std::log1p(-e);
}

TEST(UpdateDeformation, AStretchMultipliesDeformationAndVolume) {
  for (const Gradient at : {Gradient::at_start, Gradient::at_end}) {
    Deformed one(Mode::plane_strain);
    const double a = generator_of(0.01, at);
    one.by({0.01, 0.0, 0.0, 0.0, 0.0}, at);
    EXPECT_NEAR(one.particles.deformation_gradient(0, 0), std::exp(a), 1e-15);
    EXPECT_EQ(one.particles.deformation_gradient(0, 1), 0.0);
    EXPECT_EQ(one.particles.deformation_gradient(0, 3), 1.0);
    EXPECT_NEAR(one.particles.volume(0), std::exp(a), 1e-15);
    EXPECT_NEAR(one.particles.increment(0, 0), a, 1e-16);  // the strain
    EXPECT_EQ(one.particles.increment(0, 1), 0.0);
    EXPECT_EQ(one.particles.increment(0, 4), 1.0);  // the old volume
    one.by({0.01, 0.0, 0.0, 0.0, 0.0}, at);
    EXPECT_NEAR(one.particles.deformation_gradient(0, 0), std::exp(2.0 * a), 2e-15);
  }
}

TEST(UpdateDeformation, TheHoopIsStretchedInAxisymmetry) {
  Deformed one(Mode::axisymmetric);
  const double volume = one.particles.volume(0);
  one.by({0.0, 0.0, 0.0, 0.0, 0.02});
  EXPECT_NEAR(one.particles.deformation_gradient(0, 4), std::exp(0.02), 1e-15);
  EXPECT_NEAR(one.particles.volume(0), volume * std::exp(0.02), 1e-14 * volume);
  EXPECT_NEAR(one.particles.increment(0, 2), 0.02, 1e-17);
  EXPECT_EQ(one.particles.increment(0, 4), volume);
}

/// A turn by theta moves particles by f - I = R - I in a step.
TEST(UpdateDeformation, ATurnStrainsNothing) {
  const double theta = 0.05, c = std::cos(theta), s = std::sin(theta);
  const double series = 1.1 * std::pow(theta, 7) / 448.0;  // what the generator's series leaves out
  Deformed plane(Mode::plane_strain);
  plane.by({c - 1.0, -s, s, c - 1.0, 0.0});
  EXPECT_NEAR(plane.particles.deformation_gradient(0, 0), c, series);
  EXPECT_NEAR(plane.particles.deformation_gradient(0, 2), s, series);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(plane.particles.increment(0, i), 0.0, 1e-15);
  EXPECT_NEAR(plane.particles.volume(0), 1.0, 1e-15);

  Deformed space(Mode::three_dimensional);
  space.by({0.0, 0.0, 0.0, 0.0, c - 1.0, -s, 0.0, s, c - 1.0});
  EXPECT_NEAR(space.particles.deformation_gradient(0, 7), s, series);
  EXPECT_NEAR(space.particles.rotation(0, 0), std::cos(0.5 * theta), series);
  EXPECT_NEAR(space.particles.rotation(0, 1), std::sin(0.5 * theta), series);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(space.particles.increment(0, i), 0.0, 1e-15);
  EXPECT_EQ(space.particles.increment(0, 6), 1.0);
}

/// The strain of a body that has turned by a right angle is given in the frame that has not.
TEST(UpdateDeformation, StrainIsUnrotated) {
  Deformed one(Mode::plane_strain);
  Field& f = one.particles.deformation_gradient;
  f(0, 0) = f(0, 3) = 0.0;
  f(0, 1) = -1.0;
  f(0, 2) = 1.0;
  one.by({0.01, 0.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(one.particles.increment(0, 0), 0.0, 1e-16);
  EXPECT_NEAR(one.particles.increment(0, 1), generator_of(0.01, Gradient::at_start), 1e-16);
}

/// Large increments go by the general form, which takes A = dt L beyond a half.
TEST(UpdateDeformation, ALargeIncrementIsTheExponentialOfItsRate) {
  Deformed one(Mode::plane_strain);
  one.by({0.8, 0.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(one.particles.deformation_gradient(0, 0), std::exp(0.8), 1e-14);
  EXPECT_NEAR(one.particles.increment(0, 0), 0.8, 1e-15);
}

}  // namespace
}  // namespace barreno
