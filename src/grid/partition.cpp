// SPDX-License-Identifier: BSD-3-Clause
#include "grid/partition.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using ParcelList = std::vector<int>;  ///< places in the box

/// What makes a cut worse than its step, as parts of the step's cost: faces to other ranks, where
/// it has two instead of one, and parcels that change hands.
constexpr double second_face = 0.02;
constexpr double move = 0.05;

/// Parcels of the whole box, what they cost and who has them.
struct BoxParcels {
  const int (&along)[3];
  const std::vector<ParcelCost>& costs;
  const std::vector<int>& owner;  ///< empty: no owner yet

  int index(int place, int axis) const {
    if (axis == 0) return place % along[0];
    if (axis == 1) return place / along[0] % along[1];
    return place / along[0] / along[1];
  }
  const ParcelCost& cost(int place) const { return costs[static_cast<std::size_t>(place)]; }
};

/// Side of the box around a list's parcels that cost something.
int length(const BoxParcels& box, const ParcelList& list, int axis) {
  int lower = box.along[axis];
  int upper = -1;
  for (const int place : list) {
    if (!(box.cost(place).total() > 0.0)) continue;
    lower = std::min(lower, box.index(place, axis));
    upper = std::max(upper, box.index(place, axis));
  }
  return upper - lower;
}

/// The longest of these sides, the first of equal ones.
int longest_axis(const BoxParcels& box, const ParcelList& list) {
  const int sides[3] = {length(box, list, 0), length(box, list, 1), length(box, list, 2)};
  return static_cast<int>(std::max_element(sides, sides + 3) - sides);
}

/// The list slice by slice across an axis, in its old order within a slice. Linear in its length.
ParcelList by_slices(const BoxParcels& box, const ParcelList& list, int axis) {
  std::vector<std::size_t> next(static_cast<std::size_t>(box.along[axis]) + 1, 0);
  for (const int place : list) ++next[static_cast<std::size_t>(box.index(place, axis)) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  ParcelList sorted(list.size());
  for (const int place : list)
    sorted[next[static_cast<std::size_t>(box.index(place, axis))]++] = place;
  return sorted;
}

/// Ranks [first, first + count) that share a list, and how many of them take the one half.
struct Ranks {
  int first = 0;
  int count = 1;

  Ranks lower_half() const { return {first, count / 2}; }
  Ranks upper_half() const { return {first + count / 2, count - count / 2}; }
  bool holds(int rank) const { return rank >= first && rank < first + count; }
};

/// Running sums over a list: entry i is of its first i parcels.
struct Sums {
  std::vector<ParcelCost> cost;
  std::vector<double> used;                ///< parcels that cost something
  std::vector<double> at_lower, at_upper;  ///< those of them that the halves of the ranks have now

  ParcelCost cost_in(std::size_t begin, std::size_t end) const {
    return {cost[end].nodes - cost[begin].nodes, cost[end].particles - cost[begin].particles};
  }
};

Sums running_sums(const BoxParcels& box, const ParcelList& list, const Ranks& ranks) {
  const std::vector<double> none(list.size() + 1, 0.0);
  Sums sums{std::vector<ParcelCost>(list.size() + 1), none, none, none};
  for (std::size_t i = 0; i < list.size(); ++i) {
    sums.cost[i + 1] = sums.cost[i];
    sums.cost[i + 1] += box.cost(list[i]);
    const double used = box.cost(list[i]).total() > 0.0 ? 1.0 : 0.0;
    const bool nobodys = box.owner.empty();
    const int owner = nobodys ? 0 : box.owner[static_cast<std::size_t>(list[i])];
    const auto has = [&](const Ranks& half) { return nobodys || half.holds(owner) ? used : 0.0; };
    sums.used[i + 1] = sums.used[i] + used;
    sums.at_lower[i + 1] = sums.at_lower[i] + has(ranks.lower_half());
    sums.at_upper[i + 1] = sums.at_upper[i] + has(ranks.upper_half());
  }
  return sums;
}

/// A slab of a list, its places [begin, end), for one half of the ranks; the rest is for the other.
struct Cut {
  std::size_t begin = 0;
  std::size_t end = 1;
  bool for_lower = true;
  double badness = HUGE_VAL;
};

/// Longer of two halves' times in one part of the step, per rank's share of the whole.
double longer(double part, double whole, double share) {
  return std::max(part / share, (whole - part) / (1.0 - share));
}

/// What a cut costs: the step, its faces, and the parcels that change hands.
double badness(const Sums& sums, const Cut& cut, double share) {
  const std::size_t n = sums.cost.size() - 1;
  const ParcelCost whole = sums.cost.back();
  const ParcelCost part = sums.cost_in(cut.begin, cut.end);
  const auto& inside = cut.for_lower ? sums.at_lower : sums.at_upper;
  const auto& outside = cut.for_lower ? sums.at_upper : sums.at_lower;
  const double stays =
      inside[cut.end] - inside[cut.begin] + outside[n] - outside[cut.end] + outside[cut.begin];
  const double moved = 1.0 - stays / sums.used[n];
  const double faces = cut.begin > 0 && cut.end < n ? second_face : 0.0;
  return longer(part.nodes, whole.nodes, share) + longer(part.particles, whole.particles, share) +
         (faces + move * moved) * whole.total();
}

/// The best of the cuts from `begin` on whose slab costs the share to within a parcel; some is
/// left.
Cut best_cut_from(const Sums& sums, std::size_t begin, bool for_lower, double share) {
  const std::size_t n = sums.cost.size() - 1;
  const auto short_of = [](const ParcelCost& sum, double cost) { return sum.total() < cost; };
  const double goal = sums.cost[begin].total() + share * sums.cost.back().total();
  const auto found = std::lower_bound(sums.cost.begin(), sums.cost.end(), goal, short_of);
  const auto reached = static_cast<std::size_t>(found - sums.cost.begin());
  Cut best;
  for (const std::size_t end : {reached - 1, reached}) {
    if (end <= begin || end > n || end - begin == n) continue;
    Cut cut{begin, end, for_lower};
    cut.badness = badness(sums, cut, share);
    if (cut.badness < best.badness) best = cut;
  }
  return best;
}

Cut best_cut(const Sums& sums, double share) {
  const std::size_t n = sums.cost.size() - 1;
  if (sums.cost.back().total() == 0.0)
    return {0, std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(n)))};
  Cut best;
  for (const bool for_lower : {true, false})
    for (std::size_t begin = 0; begin < n; ++begin) {
      const Cut cut = best_cut_from(sums, begin, for_lower, for_lower ? share : 1.0 - share);
      if (cut.badness < best.badness) best = cut;
    }
  return best;
}

/// The list's parcels in the slab, and the others.
std::array<ParcelList, 2> cut_list(const ParcelList& list, const Cut& cut) {
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(cut.begin);
  const auto end = list.begin() + static_cast<std::ptrdiff_t>(cut.end);
  ParcelList rest(list.begin(), begin);
  rest.insert(rest.end(), end, list.end());
  return {ParcelList(begin, end), rest};
}

void bisect(
    const BoxParcels& box, const ParcelList& list, const Ranks& ranks, std::vector<int>& owner
) {
  if (ranks.count == 1 || list.size() < 2) {
    for (const int place : list) owner[static_cast<std::size_t>(place)] = ranks.first;
    return;
  }
  const ParcelList sorted = by_slices(box, list, longest_axis(box, list));
  const double share = static_cast<double>(ranks.lower_half().count) / ranks.count;
  const Cut cut = best_cut(running_sums(box, sorted, ranks), share);
  const auto [slab, rest] = cut_list(sorted, cut);
  bisect(box, cut.for_lower ? slab : rest, ranks.lower_half(), owner);
  bisect(box, cut.for_lower ? rest : slab, ranks.upper_half(), owner);
}

}  // namespace

std::vector<int> bisect_parcels(
    const int (&parcels)[3],
    const std::vector<ParcelCost>& costs,
    int ranks,
    const std::vector<int>& now
) {
  std::vector<int> owner(costs.size(), 0);
  ParcelList all(costs.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
  bisect({parcels, costs, now}, all, {0, ranks}, owner);
  return owner;
}

double step_cost(const std::vector<int>& owner, const std::vector<ParcelCost>& costs, int ranks) {
  std::vector<ParcelCost> sums(static_cast<std::size_t>(ranks));
  for (std::size_t t = 0; t < owner.size(); ++t)
    sums[static_cast<std::size_t>(owner[t])] += costs[t];
  ParcelCost longest;
  for (const ParcelCost& sum : sums)
    longest = {std::max(longest.nodes, sum.nodes), std::max(longest.particles, sum.particles)};
  return longest.total();
}

}  // namespace barreno
