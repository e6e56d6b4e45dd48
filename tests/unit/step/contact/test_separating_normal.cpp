// SPDX-License-Identifier: BSD-3-Clause
// The normal between two clouds of which only the moments are known.
#include "step/contact/separating_normal.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// Moments of a box of uniform weight, centre and half edges along rotated axes.
template <unsigned D>
struct BoxMoments {
  double values[1 + D + D * (D + 1) / 2] = {};
  BoxMoments(const double (&centre)[D], const double (&axes)[D][D], const double (&half)[D]) {
    values[0] = 2.0;
    double* second = values + 1 + D;
    for (unsigned i = 0; i < D; ++i) {
      values[1 + i] = 2.0 * centre[i];
      for (unsigned j = i; j < D; ++j) {
        double sum = centre[i] * centre[j];
        for (unsigned k = 0; k < D; ++k) sum += axes[k][i] * axes[k][j] * half[k] * half[k] / 3.0;
        *second++ = 2.0 * sum;
      }
    }
  }
};

TEST(SeparatingNormal, BoxesSideBySideAreSeparatedByTheirCommonFace) {
  const double axes[2][2] = {{0.8, 0.6}, {-0.6, 0.8}}, half[2] = {0.5, 1.4};
  // The second is moved along the face too: the means alone would give another normal.
  const double a[2] = {0.1, 0.2}, b[2] = {0.1 + 0.8 * 1.0, 0.2 + 0.6 * 1.0};
  const bool none[2] = {false, false};
  double n[2];
  separating_normal<2>(
      BoxMoments<2>(a, axes, half).values, BoxMoments<2>(b, axes, half).values, none, n
  );
  EXPECT_NEAR(n[0], 0.8, 1e-14);
  EXPECT_NEAR(n[1], 0.6, 1e-14);
}

TEST(SeparatingNormal, AtASymmetryPlaneItIsInThePlaneOrAcrossIt) {
  const double axes[2][2] = {{1.0, 0.0}, {0.0, 1.0}}, half[2] = {0.5, 0.5};
  const bool mirrored[2] = {true, false};
  const double a[2] = {0.5, 0.0}, above[2] = {0.7, 1.0}, beside[2] = {1.5, 0.1};
  double n[2];
  separating_normal<2>(
      BoxMoments<2>(a, axes, half).values, BoxMoments<2>(above, axes, half).values, mirrored, n
  );
  EXPECT_EQ(n[0], 0.0);
  EXPECT_EQ(n[1], 1.0);
  separating_normal<2>(
      BoxMoments<2>(a, axes, half).values, BoxMoments<2>(beside, axes, half).values, mirrored, n
  );
  EXPECT_EQ(n[0], 1.0);
  EXPECT_EQ(n[1], 0.0);
}

}  // namespace
}  // namespace barreno
