// SPDX-License-Identifier: BSD-3-Clause
#include "state/host_particles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(DomainCorners, FollowTheDeformationGradientCounterClockwise) {
  const double x[2] = {10.0, 20.0}, F[4] = {2.0, 0.5, 0.0, 1.0}, h[2] = {1.0, 3.0};
  const Corners expected{10.0 - 3.5, 17.0, 10.0 + 0.5, 17.0, 10.0 + 3.5, 23.0, 10.0 - 0.5, 23.0};
  EXPECT_EQ(domain_corners(x, F, h), expected);
}

TEST(DomainCorners, TornParticlesAreDrawnWithABoundedStretch) {
  const double x[2] = {0.0, 0.0}, F[4] = {0.01, 0.0, 0.0, 1000.0}, h[2] = {1.0, 1.0};
  const Corners expected{-0.01, -4.0, 0.01, -4.0, 0.01, 4.0, -0.01, 4.0};
  const Corners drawn = domain_corners(x, F, h);
  for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_NEAR(drawn[i], expected[i], 1e-15);
}

}  // namespace
}  // namespace barreno
