// SPDX-License-Identifier: BSD-3-Clause
// First moments of the grid's velocity, and the energy in them.
#include "step/transfer/gather_affine.hpp"
#include "unit/step/transfer/two_cells.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::slope;
using testing::TwoCells;

TEST(GatherAffine, MomentsAreThoseOfTheGridsVelocity) {
  TwoCells two;
  Nodes& nodes = two.state.nodes[0];
  const Patch& patch = two.state.grid.patch;
  double energy = 0.0;
  for (int tile = 0; tile < 2; ++tile)
    for (int slot = 0; slot < patch.size; ++slot) {
      int at[2];
      position_of_slot(patch, slot, at);
      double* const node = &nodes.motion(first_motion(patch, tile)) + slot * motion_components(2);
      for (int i = 0; i < 2; ++i)
        node[i] = 3.0 + TwoCells::cell_size(tile) * (slope[i][0] * at[0] + slope[i][1] * at[1]);
    }
  const ReproducibleSum remembered =
      gather_affine(two.state.grid, two.state.nodes, two.state.particles);
  for (int tile = 0; tile < 2; ++tile)
    for (int c = 0; c < 4; ++c) {
      const double g = slope[c / 2][c % 2], d = TwoCells::second_moment(tile);
      EXPECT_EQ(two.particles.affine(testing::row_in(two.particles, tile), c), g * d);
      energy += 0.5 * 4.0 * g * g * d;
    }
  EXPECT_EQ(remembered, energy);
}

TEST(GatherAffine, OtherTransfersKeepNothing) {
  State state = testing::without_affine_velocity();
  EXPECT_EQ(gather_affine(state.grid, state.nodes, state.particles), 0.0);
}

}  // namespace
}  // namespace barreno
