// SPDX-License-Identifier: BSD-3-Clause
// Every rank gets its share of the costs to within a tile, whatever they look like.
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

std::vector<ParcelCost> of_nodes(const std::vector<double>& costs) {
  std::vector<ParcelCost> all;
  all.reserve(costs.size());
  for (const double cost : costs) all.push_back({cost, 0.0});
  return all;
}

/// Every halving misses by half a tile at most, and passes what it got wrong on.
void expect_shares(const std::vector<double>& weights, int ranks) {
  const std::vector<int> owner = bisect_parcels(box, of_nodes(weights), ranks);
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
  EXPECT_EQ(bisect_parcels(few, of_nodes({1.0, 1.0}), 5), (std::vector<int>{0, 2}));
  const std::vector<int> owner = bisect_parcels(box, std::vector<ParcelCost>(tiles), 4);
  for (const int rank : {0, 1, 2, 3}) EXPECT_GT(std::count(owner.begin(), owner.end(), rank), 0);
}

/// Of a long box the parts are slices, so that ranks touch few others.
TEST(Partition, ALongBoxIsCutAcross) {
  const int bar[3] = {2, 12, 1};
  const std::vector<int> owner = bisect_parcels(bar, of_nodes(std::vector<double>(24, 1.0)), 3);
  for (std::size_t t = 0; t < owner.size(); ++t) EXPECT_EQ(owner[t], static_cast<int>(t / 8));
}

double whole_step(const std::vector<ParcelCost>& costs) {
  double sum = 0.0;
  for (const ParcelCost& cost : costs) sum += cost.total();
  return sum;
}

/// Stress costs most at one end, nodes at the other: one cut leaves a third of the step to waiting.
TEST(Partition, BothPartsOfTheStepAreHalvedWhereTheyCostInDifferentPlaces) {
  const int bar[3] = {4, 30, 1};
  std::vector<ParcelCost> costs(120, {5.0, 1.0});
  std::fill(costs.begin(), costs.begin() + 40, ParcelCost{1.0, 10.0});
  const double step = whole_step(costs);
  for (const int ranks : {2, 3, 4, 5}) {
    const double cost = step_cost(bisect_parcels(bar, costs, ranks), costs, ranks);
    EXPECT_LT(cost, 1.15 * step / ranks) << ranks;
  }
  std::vector<int> one_cut(120, 0);
  for (std::size_t t = 0; t < 120; ++t) one_cut[t] = t < 40 ? 0 : 1;
  EXPECT_GT(step_cost(one_cut, costs, 2), 1.5 * step / 2);
}

/// A second face is not paid for nothing.
TEST(Partition, TheLowerEndIsASlabWhereThatIsAsGood) {
  const int bar[3] = {1, 40, 1};
  const std::vector<ParcelCost> costs(40, {1.0, 2.0});
  const std::vector<int> owner = bisect_parcels(bar, costs, 2);
  for (std::size_t t = 0; t < owner.size(); ++t) EXPECT_EQ(owner[t], t < 20 ? 0 : 1);
}

/// Either half may have either end; a front that has moved on by a slice moves a slice.
TEST(Partition, TilesStayWhereTheyAreAsLongAsThatIsAsGood) {
  const int bar[3] = {2, 20, 1};
  std::vector<ParcelCost> costs(40, {1.0, 1.0});
  std::vector<int> now(40, 0);
  for (std::size_t t = 0; t < 20; ++t) now[t] = 1;
  EXPECT_EQ(bisect_parcels(bar, costs, 2, now), now);
  EXPECT_NE(bisect_parcels(bar, costs, 2), now);
  for (std::size_t t = 38; t < 40; ++t) costs[t] = {3.0, 3.0};
  const std::vector<int> then = bisect_parcels(bar, costs, 2, now);
  for (std::size_t t = 0; t < 40; ++t) EXPECT_EQ(then[t], t < 22 ? 1 : 0) << t;
}

}  // namespace
}  // namespace barreno
