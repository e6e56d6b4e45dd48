// SPDX-License-Identifier: BSD-3-Clause
#include "grid/partition.hpp"

#include <cmath>

namespace barreno {
namespace {

struct Block {
  int lower[3], upper[3];  ///< tiles [lower, upper)
  int length(int axis) const { return upper[axis] - lower[axis]; }
};

/// Tiles of the whole box and what they weigh.
struct Tiles {
  const int (&along)[3];
  const std::vector<double>& weights;

  std::size_t place(const int (&at)[3]) const {
    const int place = (at[2] * along[1] + at[1]) * along[0] + at[0];
    return static_cast<std::size_t>(place);
  }
};

/// visit(place of the tile, its index along the axis).
template <class Visitor>
void for_each_tile(const Tiles& tiles, const Block& block, int axis, Visitor&& visit) {
  int at[3];
  for (at[2] = block.lower[2]; at[2] < block.upper[2]; ++at[2])
    for (at[1] = block.lower[1]; at[1] < block.upper[1]; ++at[1])
      for (at[0] = block.lower[0]; at[0] < block.upper[0]; ++at[0])
        visit(tiles.place(at), at[axis]);
}

/// Weight of each slice of a block across an axis.
std::vector<double> slice_weights(const Tiles& tiles, const Block& block, int axis) {
  std::vector<double> sums(static_cast<std::size_t>(block.length(axis)), 0.0);
  for_each_tile(tiles, block, axis, [&](std::size_t place, int slice) {
    sums[static_cast<std::size_t>(slice - block.lower[axis])] += tiles.weights[place];
  });
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

/// The longest side of a block, the first of equal ones.
int longest_axis(const Block& block) {
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (block.length(d) > block.length(axis)) axis = d;
  return axis;
}

void bisect(
    const Tiles& tiles, const Block& block, int first_rank, int ranks, std::vector<int>& owner
) {
  const int axis = longest_axis(block);
  if (ranks == 1 || block.length(axis) == 1) {
    for_each_tile(tiles, block, axis, [&](std::size_t place, int) { owner[place] = first_rank; });
    return;
  }
  const int first = ranks / 2;
  const int cut = block.lower[axis] +
                  best_cut(slice_weights(tiles, block, axis), static_cast<double>(first) / ranks);
  Block low = block;
  Block high = block;
  low.upper[axis] = cut;
  high.lower[axis] = cut;
  bisect(tiles, low, first_rank, first, owner);
  bisect(tiles, high, first_rank + first, ranks - first, owner);
}

}  // namespace

std::vector<int> bisect_tiles(
    const int (&tiles)[3], const std::vector<double>& weights, int ranks
) {
  std::vector<int> owner(weights.size(), 0);
  bisect({tiles, weights}, {{0, 0, 0}, {tiles[0], tiles[1], tiles[2]}}, 0, ranks, owner);
  return owner;
}

}  // namespace barreno
