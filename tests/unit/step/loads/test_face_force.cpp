// SPDX-License-Identifier: BSD-3-Clause
// Area of a face of a deformed particle, and the force of a load on it.
#include "base/numbers.hpp"
#include "step/loads/face_force.hpp"
#include "unit/step/loads/two_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::axial;
using testing::density;
using testing::h;
using testing::shear;
using testing::two_particles;

constexpr int top = static_cast<int>(Face::y_upper);

/// Nanson on a ring of a square of side h between the radii 3 h and 4 h.
TEST(FaceArea, OfARingIsThatOfItsOwnRadius) {
  Scene scene = two_particles(LoadKind::pressure, Face::y_upper, 4e6);
  scene.grid.mode = Mode::axisymmetric;
  const State state = testing::in_tiles(scene, 1.0);
  const Particles& particles = state.particles[0];
  const auto area = [&](Face face) {
    return face_area<Axisymmetric>(particles, 0, static_cast<int>(face));
  };
  EXPECT_DOUBLE_EQ(area(Face::x_upper)[0], two_pi * 4.0 * h * h);
  EXPECT_DOUBLE_EQ(area(Face::x_lower)[0], -two_pi * 3.0 * h * h);
  EXPECT_DOUBLE_EQ(area(Face::y_upper)[1], two_pi * 3.5 * h * h);
  EXPECT_EQ(area(Face::y_upper)[0], 0.0);
}

/// A shear of 1/2 along x tilts the faces across x: F^-T N = (1, -1/2) on the right.
TEST(FaceArea, OfAShearedParticleIsTilted) {
  const State state = testing::in_tiles(two_particles(LoadKind::pressure, Face::y_upper, 4e6), 1.0);
  const Particles& particles = state.particles[0];
  particles.deformation_gradient(0, 1) = 0.5;
  const Vector right = face_area<PlaneStrain>(particles, 0, static_cast<int>(Face::x_upper));
  EXPECT_DOUBLE_EQ(right[0], h);
  EXPECT_DOUBLE_EQ(right[1], -0.5 * h);
  const Vector above = face_area<PlaneStrain>(particles, 0, top);
  EXPECT_EQ(above[0], 0.0);
  EXPECT_DOUBLE_EQ(above[1], h);
}

TEST(FaceForce, OfAPressureIsOppositeToTheArea) {
  const State state = testing::in_tiles(two_particles(LoadKind::pressure, Face::y_upper, 4e6), 1.0);
  const Vector force = face_force<PlaneStrain>({4e6, false, false}, state.particles[0], 0, top);
  EXPECT_EQ(force[0], 0.0);
  EXPECT_DOUBLE_EQ(force[1], -4e6 * h);
  EXPECT_EQ(force[2], 0.0);
}

/// The particle moves with (3, 2).
TEST(FaceForce, OfANonReflectingFaceIsThatOfDashpotsUnderThePressure) {
  const State state =
      testing::in_tiles(two_particles(LoadKind::non_reflecting, Face::y_upper, 5e5), 1.0);
  const Particles& particles = state.particles[0];
  particles.shear_modulus(0) = shear;  // project_loads sets it
  const Vector force = face_force<PlaneStrain>({5e5, true, false}, particles, 0, top);
  const double normal = std::sqrt(density * axial), tangential = std::sqrt(density * shear);
  EXPECT_NEAR(force[0], -3.0 * tangential * h, 1e-12 * tangential);
  EXPECT_NEAR(force[1], -(2.0 * normal + 5e5) * h, 1e-12 * normal);
  EXPECT_NEAR(
      face_impedance(particles, 0, face_area<PlaneStrain>(particles, 0, top)),
      normal * h,
      1e-12 * normal
  );
}

}  // namespace
}  // namespace barreno
