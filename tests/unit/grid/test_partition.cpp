// SPDX-License-Identifier: BSD-3-Clause
// Every rank gets its share of the weights to within a tile, whatever they look like.
#include "grid/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace barreno {
namespace {

constexpr int box[3] = {9, 14, 5};
constexpr int tiles = box[0] * box[1] * box[2];

/// A front of a spherical wave: few tiles cost much, most nothing.
std::vector<double> wave_front(double radius) {
  std::vector<double> weights;
  for (int z = 0; z < box[2]; ++z)
    for (int y = 0; y < box[1]; ++y)
      for (int x = 0; x < box[0]; ++x)
        weights.push_back(
            std::sqrt(x * x + y * y + z * z) < radius ? 1.0 + 0.1 * (x + y + z) : 0.0
        );
  return weights;
}
std::vector<double> scattered() {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> weights(tiles);
  for (double& w : weights) w = std::pow(uniform(generator), 4);
  return weights;
}

/// Every halving misses by half a tile at most, and passes what it got wrong on.
void expect_shares(const std::vector<double>& weights, int ranks) {
  const std::vector<int> owner = bisect_tiles(box, weights, ranks);
  ASSERT_EQ(owner.size(), weights.size());
  std::vector<double> sums(static_cast<std::size_t>(ranks), 0.0);
  std::vector<int> counts(static_cast<std::size_t>(ranks), 0);
  for (std::size_t t = 0; t < owner.size(); ++t) {
    ASSERT_GE(owner[t], 0);
    ASSERT_LT(owner[t], ranks);
    sums[static_cast<std::size_t>(owner[t])] += weights[t];
    ++counts[static_cast<std::size_t>(owner[t])];
  }
  const double share = std::accumulate(weights.begin(), weights.end(), 0.0) / ranks;
  const double heaviest = *std::max_element(weights.begin(), weights.end());
  for (const double sum : sums) EXPECT_NEAR(sum, share, heaviest * (1.0 + 1e-12)) << ranks;
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 0) << ranks;
}

TEST(Partition, EveryRankGetsItsShareToWithinATile) {
  for (const int ranks : {1, 2, 3, 4, 7, 16}) {
    expect_shares(std::vector<double>(tiles, 1.0), ranks);
    expect_shares(wave_front(6.0), ranks);
    expect_shares(wave_front(3.2), ranks);
    expect_shares(scattered(), ranks);
  }
}

TEST(Partition, AllRanksButSomeHaveTilesWhereTheyAreFewOrWeighNothing) {
  const int few[3] = {2, 1, 1};
  EXPECT_EQ(bisect_tiles(few, {1.0, 1.0}, 5), (std::vector<int>{0, 2}));
  const std::vector<int> owner = bisect_tiles(box, std::vector<double>(tiles, 0.0), 4);
  for (const int rank : {0, 1, 2, 3}) EXPECT_GT(std::count(owner.begin(), owner.end(), rank), 0);
}

/// Of a long box the parts are slices, so that ranks touch few others.
TEST(Partition, ALongBoxIsCutAcross) {
  const int bar[3] = {2, 12, 1};
  const std::vector<int> owner = bisect_tiles(bar, std::vector<double>(24, 1.0), 3);
  for (std::size_t t = 0; t < owner.size(); ++t) EXPECT_EQ(owner[t], static_cast<int>(t / 8));
}

}  // namespace
}  // namespace barreno
