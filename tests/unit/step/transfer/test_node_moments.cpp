// SPDX-License-Identifier: BSD-3-Clause
// Moments of the weights of a particle, and their inverse.
#include "step/transfer/node_moments.hpp"
#include "unit/shape/shape_cases.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

constexpr double corner[3] = {1.25, 2.375, 1.5};

template <class M, class S>
NodeMoments<M::dimensions> moments_of() {
  testing::ShapeCase c = testing::particle_at<M>(corner, 2, 0.0);
  for (int d = 0; d < M::dimensions; ++d) {
    // Splines change at walls; here there is none.
    c.particle.low[d] = -100.0;
    c.particle.high[d] = 100.0;
  }
  return {make_patch(M::dimensions, testing::reach), S::template support<M>(c.particle)};
}

/// D is `along` on its diagonal, and the weights have their centre at the particle.
template <class M, class S>
void expect_moments(double along) {
  const auto moments = moments_of<M, S>();
  for (int d = 0; d < M::dimensions; ++d) {
    EXPECT_NEAR(moments.centre[d], testing::reach + corner[d], 1e-13);
    for (int e = 0; e < M::dimensions; ++e)
      EXPECT_NEAR(moments.second[d][e], d == e ? along : 0.0, 1e-13);
  }
}

TEST(NodeMoments, OfQuadraticSplinesAreAQuarterOfASquareCell) {
  expect_moments<PlaneStrain, QuadraticSpline>(1.0 / 4.0);
  expect_moments<ThreeDimensional, QuadraticSpline>(1.0 / 4.0);
}

TEST(NodeMoments, OfCubicSplinesAreAThirdOfASquareCell) {
  expect_moments<PlaneStrain, CubicSpline>(1.0 / 3.0);
  expect_moments<ThreeDimensional, CubicSpline>(1.0 / 3.0);
}

/// s (1 - s) at a distance s from the lower node.
TEST(NodeMoments, OfLinearFunctionsDependOnThePlace) {
  const auto moments = moments_of<PlaneStrain, Linear>();
  EXPECT_NEAR(moments.second[0][0], 0.25 * 0.75, 1e-13);
  EXPECT_NEAR(moments.second[1][1], 0.375 * 0.625, 1e-13);
}

TEST(InverseMoments, SolveTheirMatrix) {
  const double a[3][3] = {{4.0, 2.0, 0.0}, {2.0, 5.0, 1.0}, {0.0, 1.0, 3.0}};
  const double b[3] = {8.0, 15.0, 11.0};
  double x[3];
  InverseMoments<3>(a).solve(b, x);
  EXPECT_DOUBLE_EQ(x[0], 1.0);
  EXPECT_DOUBLE_EQ(x[1], 2.0);
  EXPECT_DOUBLE_EQ(x[2], 3.0);
}

TEST(InverseMoments, DirectionsWithoutASpreadGetNothing) {
  const double a[2][2] = {{0.0, 0.0}, {0.0, 0.25}}, b[2] = {0.0, 0.5};
  double x[2];
  InverseMoments<2>(a).solve(b, x);
  EXPECT_EQ(x[0], 0.0);
  EXPECT_EQ(x[1], 2.0);
}

}  // namespace
}  // namespace barreno
