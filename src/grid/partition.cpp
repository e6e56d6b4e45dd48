// SPDX-License-Identifier: BSD-3-Clause
#include "grid/partition.hpp"

#include <cmath>

namespace barreno {
namespace {

struct Block {
  int lower[2], upper[2];  ///< tiles [lower, upper)
};

std::size_t place_of(int x, int y, int row_length) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(row_length) +
         static_cast<std::size_t>(x);
}

/// Weight of each row (axis 1) or column (axis 0) of a block.
std::vector<double> slice_weights(
    const Block& block, int axis, int row_length, const std::vector<double>& weights
) {
  std::vector<double> sums(static_cast<std::size_t>(block.upper[axis] - block.lower[axis]), 0.0);
  for (int y = block.lower[1]; y < block.upper[1]; ++y)
    for (int x = block.lower[0]; x < block.upper[0]; ++x)
      sums[static_cast<std::size_t>((axis == 0 ? x : y) - block.lower[axis])] +=
          weights[place_of(x, y, row_length)];
  return sums;
}

/// Where to cut so that the first part comes nearest to `share` of the whole; both parts keep a
/// slice.
int best_cut(const std::vector<double>& slices, double share) {
  double total = 0.0;
  for (const double w : slices) total += w;
  const int n = static_cast<int>(slices.size());
  int best = 1;
  double best_miss = HUGE_VAL;
  double before = 0.0;
  for (int cut = 1; cut < n; ++cut) {
    before += slices[static_cast<std::size_t>(cut - 1)];
    const double miss = std::abs(before - share * total);
    if (miss < best_miss) {
      best_miss = miss;
      best = cut;
    }
  }
  return best;
}

void bisect(
    const Block& block,
    int first_rank,
    int ranks,
    int row_length,
    const std::vector<double>& weights,
    std::vector<int>& owner
) {
  const int width = block.upper[0] - block.lower[0];
  const int height = block.upper[1] - block.lower[1];
  if (ranks == 1 || width * height == 1) {
    for (int y = block.lower[1]; y < block.upper[1]; ++y)
      for (int x = block.lower[0]; x < block.upper[0]; ++x)
        owner[place_of(x, y, row_length)] = first_rank;
    return;
  }
  const int axis = width >= height ? 0 : 1;
  const int first = ranks / 2;
  const int cut =
      block.lower[axis] +
      best_cut(slice_weights(block, axis, row_length, weights), static_cast<double>(first) / ranks);
  Block low = block;
  Block high = block;
  low.upper[axis] = cut;
  high.lower[axis] = cut;
  bisect(low, first_rank, first, row_length, weights, owner);
  bisect(high, first_rank + first, ranks - first, row_length, weights, owner);
}

}  // namespace

std::vector<int> bisect_tiles(
    const int (&tiles)[2], const std::vector<double>& weights, int ranks
) {
  std::vector<int> owner(weights.size(), 0);
  bisect({{0, 0}, {tiles[0], tiles[1]}}, 0, ranks, tiles[0], weights, owner);
  return owner;
}

}  // namespace barreno
