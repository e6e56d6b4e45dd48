// SPDX-License-Identifier: BSD-3-Clause
#include "step/grid_share.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

GridShare share(double pic_fraction, double damping) {
  StepSpec step;
  step.pic_fraction = pic_fraction;
  step.damping = damping;
  return GridShare(step);
}

/// b + (1 - b) min(1, c dt).
TEST(GridShare, IsThePicFractionAndWhatDampingTakesOfTheRest) {
  EXPECT_EQ(share(0.0, 0.0)(0.5), 0.0);
  EXPECT_EQ(share(0.25, 0.0)(0.5), 0.25);
  EXPECT_EQ(share(0.25, 1.0)(0.5), 0.25 + 0.75 * 0.5);
  EXPECT_EQ(share(1.0, 1.0)(0.5), 1.0);
  EXPECT_EQ(share(0.25, 8.0)(0.5), 1.0);  // never more than the grid's own velocity
}

}  // namespace
}  // namespace barreno
