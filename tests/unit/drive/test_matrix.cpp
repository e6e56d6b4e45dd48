// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "drive/matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

Mat3 rotation_about(double x, double y, double z, double angle) {
  return exponential(angle * Mat3{{{0, -z, y}, {z, 0, -x}, {-y, x, 0}}});
}

double distance(const Mat3& a, const Mat3& b) {
  return norm(a - b);
}

const Mat3 general{{{1.3, 0.2, -0.4}, {-0.1, 0.7, 0.3}, {0.25, -0.35, 1.1}}};

TEST(Matrix, InverseTimesItselfIsIdentity) {
  EXPECT_LE(distance(inverse(general) * general, identity()), 1e-15 * 8);
}

TEST(Matrix, ExponentialOfADiagonalAndOfATurn) {
  const Mat3 grown = exponential(Mat3{{{2.0, 0, 0}, {0, -3.0, 0}, {0, 0, 1e-9}}});
  EXPECT_NEAR(grown(0, 0), std::exp(2.0), 1e-14 * std::exp(2.0));
  EXPECT_NEAR(grown(1, 1), std::exp(-3.0), 1e-14);
  EXPECT_NEAR(grown(2, 2), std::exp(1e-9), 1e-14);
  const Mat3 turn = rotation_about(0, 0, 1, 1.0);
  EXPECT_NEAR(turn(0, 0), std::cos(1.0), 1e-15 * 4);
  EXPECT_NEAR(turn(1, 0), std::sin(1.0), 1e-15 * 4);
}

TEST(Matrix, LogarithmUndoesTheExponential) {
  for (const double size : {1e-12, 1e-4, 0.1, 0.3, 1.0, 2.0}) {
    const Mat3 a = size * Mat3{{{0.3, -0.8, 0.1}, {0.6, -0.2, 0.5}, {-0.3, 0.4, 0.15}}};
    const auto log = logarithm_1p(exponential(a) - identity());
    ASSERT_TRUE(log.has_value()) << size;
    // exp(a) - I carries the round-off of I.
    EXPECT_LE(distance(*log, a), 2e-15 * std::exp(2.0 * size)) << size;
  }
}

TEST(Matrix, LogarithmOfASmallStretchKeepsItsDigits) {
  for (const double g : {1e-15, -1e-9, 1e-3, -0.2, 0.9, -0.99, 1e3}) {
    const auto log = logarithm_1p(Mat3{{{g, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
    ASSERT_TRUE(log.has_value()) << g;
    EXPECT_NEAR((*log)(0, 0), std::log1p(g), 4e-15 * std::abs(std::log1p(g))) << g;
    EXPECT_EQ((*log)(1, 1), 0.0);
  }
}

TEST(Matrix, LogarithmOfATurnIsItsSpin) {
  for (const double angle : {1e-6, 0.5, 3.0, pi - 1e-3}) {
    const auto log = logarithm_1p(rotation_about(0, 0, 1, angle) - identity());
    ASSERT_TRUE(log.has_value()) << angle;
    EXPECT_NEAR((*log)(1, 0), angle, 1e-12) << angle;
    EXPECT_LE(std::abs(trace(symmetric_part(*log))), 1e-13) << angle;
  }
}

TEST(Matrix, HalfATurnHasNoLogarithm) {
  EXPECT_FALSE(logarithm_1p(rotation_about(0, 0, 1, pi) - identity()).has_value());
  EXPECT_FALSE(logarithm_1p(Mat3{{{-2, 0, 0}, {0, -2, 0}, {0, 0, 0}}}).has_value());
  EXPECT_FALSE(logarithm_1p(Mat3{{{-1.5, 0, 0}, {0, -4.0, 0}, {0, 0, 0}}}).has_value());
}

TEST(Matrix, PolarRotationIsOrthogonalAndLeavesASymmetricStretch) {
  const Mat3 stretched =
      rotation_about(0.6, 0, 0.8, 2.5) * Mat3{{{5e-3, 0, 0}, {0, 2e2, 0}, {0, 0, 1}}};
  for (const Mat3& f : {general, stretched, rotation_about(0, 0, 1, 3.1)}) {
    const Mat3 r = polar_rotation(f);
    EXPECT_LE(distance(transpose(r) * r, identity()), 1e-14);
    const Mat3 u = transpose(r) * f;
    EXPECT_LE(distance(u, transpose(u)), 1e-14 * norm(f));
    EXPECT_GT(determinant(r), 0.0);
  }
}

TEST(Matrix, RotateIsUndoneByUnrotate) {
  const Sym3 t{1, -2, 3, 0.4, -0.5, 0.6};
  const Mat3 r = rotation_about(0.6, 0, 0.8, 1.2);
  EXPECT_LE(norm(unrotate(r, rotate(r, t)) - t), 4e-14);
  // Quarter turn about z: x becomes y.
  const Sym3 turned = rotate(rotation_about(0, 0, 1, pi / 2), {1, 0, 0, 0, 0, 0});
  EXPECT_NEAR(turned.yy, 1.0, 1e-15 * 4);
}

}  // namespace
}  // namespace barreno
