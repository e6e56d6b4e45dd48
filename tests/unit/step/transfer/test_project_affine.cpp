// SPDX-License-Identifier: BSD-3-Clause
// Momenta of the first moments, at the corners of a cell.
#include "step/transfer/project_affine.hpp"
#include "unit/step/transfer/two_cells.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

using testing::slope;
using testing::TwoCells;

/// p_I = S m G (x_I - x_p), with G = B D^-1.
TEST(ProjectAffine, MomentaTurnAboutTheParticle) {
  TwoCells two;
  for (int tile = 0; tile < 2; ++tile)
    for (int c = 0; c < 4; ++c)
      two.particles.affine(testing::row_in(two.particles, tile), c) =
          slope[c / 2][c % 2] * TwoCells::second_moment(tile);
  Nodes& nodes = two.state.nodes[0];
  project_affine(two.state.grid, two.particles, nodes);
  for (int tile = 0; tile < 2; ++tile)
    for (const int x : {0, 1})
      for (const int y : {0, 1}) {
        const double h = TwoCells::cell_size(tile);
        const double at[] = {(x - 0.5) * h, (y - 0.5) * h};
        const double* const node =
            &nodes.sums(first_sum(two.state.grid.patch, tile)) +
            testing::slot_of(two.state.grid.patch, 3 + x, 3 + y) * sum_components;
        EXPECT_EQ(node[0], 0.0);  // no mass
        for (int i = 0; i < 2; ++i)
          EXPECT_EQ(node[1 + i], 0.25 * 4.0 * (slope[i][0] * at[0] + slope[i][1] * at[1]));
      }
}

TEST(ProjectAffine, OtherTransfersAddNothing) {
  State state = testing::without_affine_velocity();
  const ArrayView<double>& sums = state.nodes[0].sums;
  project_affine(state.grid, state.particles[0], state.nodes[0]);
  for (std::size_t i = 0; i < sums.extent(0); ++i) ASSERT_EQ(sums(i), 0.0);
}

}  // namespace
}  // namespace barreno
