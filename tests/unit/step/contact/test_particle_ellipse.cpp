// SPDX-License-Identifier: BSD-3-Clause
// How far a deformed particle reaches.
#include "step/contact/particle_ellipse.hpp"
#include "unit/step/contact/two_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

/// Half edges of a quarter, twice as long along x, in cells of a half: half axes of 1 and 1/2.
TEST(ParticleEllipse, ReachesAlongADirectionAsFarAsItsDeformedBoxLets) {
  const State state = testing::in_tiles(
      testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::frictionless), 1.0
  );
  const Particles& particles = state.particles[0];
  particles.deformation_gradient(0, 0) = 2.0;
  ParticleGeometry place;
  place.x[0] = 3.0;
  place.x[1] = 5.0;
  place.per_cell = 2.0;
  const ParticleEllipse<2> ellipse(place, particles, 0);
  EXPECT_EQ(ellipse.x[0], 3.0);
  EXPECT_EQ(ellipse.x[1], 5.0);
  const double across_up_aslant[2][3] = {{1.0, 0.0, 0.6}, {0.0, -1.0, 0.8}};
  double reach[3];
  ellipse.reach(across_up_aslant, 3, reach);
  EXPECT_DOUBLE_EQ(reach[0], 1.0);
  EXPECT_DOUBLE_EQ(reach[1], 0.5);
  EXPECT_DOUBLE_EQ(reach[2], std::sqrt(0.36 + 0.16));
}

}  // namespace
}  // namespace barreno
