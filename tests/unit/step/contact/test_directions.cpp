// SPDX-License-Identifier: BSD-3-Clause
// Directions about a normal.
#include "step/contact/directions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

template <unsigned D>
void expect_cone(const double (&n)[D]) {
  const Directions<D> directions(0.5, true);
  double together[D][Directions<D>::all];
  directions.find_all(typename Directions<D>::About(n), together);
  EXPECT_EQ(directions.different, Directions<D>::count);
  for (int k = 0; k < Directions<D>::count; ++k) {
    double out[D];
    directions.find(typename Directions<D>::About(n), k, out);
    double squared = 0.0;
    double along = 0.0;
    for (unsigned d = 0; d < D; ++d) {
      squared += out[d] * out[d];
      along += out[d] * n[d];
    }
    for (unsigned d = 0; d < D; ++d) EXPECT_NEAR(together[d][k], out[d], 1e-15);
    EXPECT_NEAR(squared, 1.0, 1e-14);
    EXPECT_GT(along, k <= Directions<D>::turned ? std::cos(0.5) - 1e-14 : 0.5 - 1e-14);
  }
}

TEST(Directions, AreUnitVectorsNearTheNormal) {
  expect_cone<2>({0.6, -0.8});
  expect_cone<3>({0.48, -0.64, 0.6});
  expect_cone<3>({1.0, 0.0, 0.0});
  expect_cone<3>({0.0, 0.0, -1.0});
}

/// In the plane four turns of 1/4, 1/2, 3/4 and the whole of the spread, to either side.
TEST(Directions, AreTurnedByFractionsOfTheSpread) {
  const Directions<2> directions(0.4, false);
  const double n[2] = {1.0, 0.0};
  for (int k = 1; k <= Directions<2>::turned; ++k) {
    double out[2];
    directions.find(Directions<2>::About(n), k, out);
    const int turn = (k + 1) / 2;
    const double angle = 0.1 * turn;
    EXPECT_NEAR(std::atan2(out[1], out[0]), k % 2 == 1 ? angle : -angle, 1e-15);
  }
}

TEST(Directions, AxesAreThoseLessThan60DegreesAwayInTheFirstRoundOnly) {
  const double n[2] = {0.28, -0.96};
  double out[2];
  Directions<2>(0.4, true).find(Directions<2>::About(n), Directions<2>::turned + 2, out);
  EXPECT_EQ(out[0], 0.0);
  EXPECT_EQ(out[1], -1.0);
  Directions<2>(0.4, true).find(
      Directions<2>::About(n), Directions<2>::turned + 1, out
  );  // further: the normal again
  EXPECT_EQ(out[0], n[0]);
  Directions<2>(0.4, false).find(Directions<2>::About(n), Directions<2>::turned + 2, out);
  EXPECT_EQ(out[1], n[1]);
}

}  // namespace
}  // namespace barreno
