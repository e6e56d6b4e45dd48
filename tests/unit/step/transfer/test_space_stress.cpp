// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/space_stress.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// After a turn by a right angle about z what acted along x acts along y.
TEST(SpaceStress, TurnsWithTheParticle) {
  State state = testing::start_in_tiles(testing::two_tiles(testing::elastic(1.0, 0.25, 4.0)));
  const Particles& particles = state.particles[0];
  const double stress[] = {5.0, 3.0, 2.0, 1.0};
  for (int c = 0; c < 4; ++c) particles.stress(0, c) = stress[c];
  const double turn[] = {0.0, -1.0, 1.0, 0.0};
  for (int c = 0; c < 4; ++c) particles.deformation_gradient(0, c) = turn[c];
  const Sym3 space = rotated_stress<PlaneStrain>(
      particles.stress, particles.deformation_gradient.values, particles.rotation.values, 0
  );
  EXPECT_DOUBLE_EQ(space.xx, 3.0);
  EXPECT_DOUBLE_EQ(space.yy, 5.0);
  EXPECT_DOUBLE_EQ(space.zz, 2.0);
  EXPECT_DOUBLE_EQ(space.xy, -1.0);
}

}  // namespace
}  // namespace barreno
