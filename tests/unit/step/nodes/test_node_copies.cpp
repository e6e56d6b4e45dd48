// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/node_copies.hpp"
#include "step/transfer/project_particles.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace barreno {
namespace {

TEST(NodeCopies, ANodeIsFoundInEveryPatchThatHoldsIt) {
  State state = testing::start_in_tiles(testing::two_tiles(testing::elastic(1.0, 0.25, 4.0)));
  const Patch& patch = state.grid.patch;
  const NodeCopies copies(state.grid);
  const int left = testing::slot_of(patch, 8, 2), right = testing::slot_of(patch, 0, 2);
  for (const auto& [tile, slot] : {std::pair{0, left}, std::pair{1, right}}) {
    std::vector<std::pair<int, int>> found;
    copies.for_each(tile, slot, [&](int other, int there) { found.emplace_back(other, there); });
    EXPECT_EQ(found, (std::vector<std::pair<int, int>>{{0, left}, {1, right}}));
  }
  std::vector<std::pair<int, int>> alone;
  const int inside = testing::slot_of(patch, 4, 4);
  copies.for_each(1, inside, [&](int other, int there) { alone.emplace_back(other, there); });
  EXPECT_EQ(alone, (std::vector<std::pair<int, int>>{{1, inside}}));

  Nodes& nodes = state.nodes[0];
  clear_nodes(state.grid, nodes);
  (&nodes.sums(first_sum(patch, 0)))[left * sum_components] = 1.0;
  (&nodes.sums(first_sum(patch, 1)))[right * sum_components] = 0.25;
  double total[sum_components];
  copies.add(nodes.sums, sum_components, 1, right, total);
  EXPECT_EQ(total[0], 1.25);
}

}  // namespace
}  // namespace barreno
