// SPDX-License-Identifier: BSD-3-Clause
// Nodes of refined tiles as means of coarser ones.
#include "grid/coarse_nodes.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// The nodes of all slots of a refined tile.
void expect_means(const Patch& patch, const TilePosition& at) {
  const auto node = [&](int tile, int place) {
    return tile * patch.tile_cells - patch.reach + place;
  };
  for (int slot = 0; slot < patch.size; ++slot) {
    double sum = 0.0, centre[3] = {};
    for_each_coarse_node(patch, at, slot, [&](int coarse, double weight) {
      ASSERT_GE(coarse, 0);
      ASSERT_LT(coarse, patch.size);
      int place[3];
      position_of_slot(patch, coarse, place);
      sum += weight;
      for (int d = 0; d < patch.dimensions; ++d)
        centre[d] += 2.0 * weight * node(at[d] >> 1, place[d]);
    });
    int place[3];
    position_of_slot(patch, slot, place);
    EXPECT_EQ(sum, 1.0);
    for (int d = 0; d < patch.dimensions; ++d) EXPECT_EQ(centre[d], node(at[d], place[d]));
  }
}

/// The weights of the coarser nodes add up to one and have their centre at the finer node, whatever
/// the place of the refined tile in the coarser one.
TEST(CoarseNodes, AreExactForLinearFunctions) {
  for (const int dimension : {2, 3})
    for (const int reach : {1, 2, 8})
      for (const int odd : {0, 1}) {
        const TilePosition at{{6 + odd, 4, dimension == 3 ? 2 + odd : 0}, 1};
        expect_means(make_patch(dimension, reach), at);
      }
}

}  // namespace
}  // namespace barreno
