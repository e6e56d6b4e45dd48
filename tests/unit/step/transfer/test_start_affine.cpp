// SPDX-License-Identifier: BSD-3-Clause
// First moments of the initial velocity.
#include "step/transfer/start_affine.hpp"
#include "unit/step/transfer/two_cells.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::slope;
using testing::TwoCells;

TEST(StartAffine, MomentsAreThoseOfTheInitialGradient) {
  TwoCells two;
  for (int p = 0; p < 2; ++p)
    for (int c = 0; c < 4; ++c) two.particles.affine(p, c) = slope[c / 2][c % 2];
  start_affine(two.state.grid, two.state.particles);
  for (int tile = 0; tile < 2; ++tile)
    for (int c = 0; c < 4; ++c)
      EXPECT_EQ(
          two.particles.affine(testing::row_in(two.particles, tile), c),
          slope[c / 2][c % 2] * TwoCells::second_moment(tile)
      );
}

TEST(StartAffine, OtherTransfersHaveNoMoments) {
  State state = testing::without_affine_velocity();
  start_affine(state.grid, state.particles);
  EXPECT_EQ(state.particles[0].affine.components, 0);
}

}  // namespace
}  // namespace barreno
