// SPDX-License-Identifier: BSD-3-Clause
#include "grid/partition.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using TileList = std::vector<int>;  ///< places in the box

/// Tiles of the whole box and what they weigh.
struct Tiles {
  const int (&along)[3];
  const std::vector<double>& weights;

  int index(int place, int axis) const {
    if (axis == 0) return place % along[0];
    if (axis == 1) return place / along[0] % along[1];
    return place / along[0] / along[1];
  }
  double weight(int place) const { return weights[static_cast<std::size_t>(place)]; }
};

/// Side of the box around a list's tiles that weigh something.
int length(const Tiles& tiles, const TileList& list, int axis) {
  int lower = tiles.along[axis];
  int upper = -1;
  for (const int place : list) {
    if (!(tiles.weight(place) > 0.0)) continue;
    lower = std::min(lower, tiles.index(place, axis));
    upper = std::max(upper, tiles.index(place, axis));
  }
  return upper - lower;
}

/// The longest of these sides, the first of equal ones.
int longest_axis(const Tiles& tiles, const TileList& list) {
  const int sides[3] = {length(tiles, list, 0), length(tiles, list, 1), length(tiles, list, 2)};
  return static_cast<int>(std::max_element(sides, sides + 3) - sides);
}

/// The list slice by slice across an axis, in its old order within a slice. Linear in its length.
TileList by_slices(const Tiles& tiles, const TileList& list, int axis) {
  std::vector<std::size_t> next(static_cast<std::size_t>(tiles.along[axis]) + 1, 0);
  for (const int place : list) ++next[static_cast<std::size_t>(tiles.index(place, axis)) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  TileList sorted(list.size());
  for (const int place : list)
    sorted[next[static_cast<std::size_t>(tiles.index(place, axis))]++] = place;
  return sorted;
}

/// How many tiles make a first part that comes nearest to `share` of the whole; both parts get one.
std::size_t best_cut(const Tiles& tiles, const TileList& list, double share) {
  double total = 0.0;
  for (const int place : list) total += tiles.weight(place);
  if (total == 0.0)
    return std::max<std::size_t>(
        1, static_cast<std::size_t>(share * static_cast<double>(list.size()))
    );
  std::size_t best = 1;
  double best_miss = HUGE_VAL;
  double before = 0.0;
  for (std::size_t cut = 1; cut < list.size(); ++cut) {
    before += tiles.weight(list[cut - 1]);
    const double miss = std::abs(before - share * total);
    if (miss < best_miss) {
      best_miss = miss;
      best = cut;
    }
  }
  return best;
}

void bisect(
    const Tiles& tiles, const TileList& list, int first_rank, int ranks, std::vector<int>& owner
) {
  if (ranks == 1 || list.size() < 2) {
    for (const int place : list) owner[static_cast<std::size_t>(place)] = first_rank;
    return;
  }
  const int first = ranks / 2;
  const TileList sorted = by_slices(tiles, list, longest_axis(tiles, list));
  const auto cut =
      sorted.begin() +
      static_cast<std::ptrdiff_t>(best_cut(tiles, sorted, static_cast<double>(first) / ranks));
  bisect(tiles, TileList(sorted.begin(), cut), first_rank, first, owner);
  bisect(tiles, TileList(cut, sorted.end()), first_rank + first, ranks - first, owner);
}

}  // namespace

std::vector<int> bisect_tiles(
    const int (&tiles)[3], const std::vector<double>& weights, int ranks
) {
  std::vector<int> owner(weights.size(), 0);
  TileList all(weights.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
  bisect({tiles, weights}, all, 0, ranks, owner);
  return owner;
}

}  // namespace barreno
