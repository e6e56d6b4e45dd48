// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/piece.hpp"
#include "geometry/slices.hpp"

#include <algorithm>
#include <optional>

namespace barreno {
namespace {

/// A plane of the coordinates that cuts a box in two.
struct Cut {
  std::size_t axis;
  double place;
};

std::optional<Cut> cut_between(const Box& box, std::size_t axis, double place) {
  if (place > box.lower[axis] && place < box.upper[axis]) return Cut{axis, place};
  return {};
}

/// A flat side, along the coordinates, of a shape inside a box.
std::optional<Cut> flat_side(const Shape& shape, const Box& box, int dimension) {
  if (const auto* own = std::get_if<Box>(&shape)) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
      for (const double place : {own->lower[i], own->upper[i]})
        if (const auto cut = cut_between(box, i, place)) return cut;
  }
  if (const auto* cone = std::get_if<Cone>(&shape))
    if (const auto round = round_of(*cone))
      for (const double place : {round->from, round->to})
        if (const auto cut = cut_between(box, round->axis, place)) return cut;
  const auto* polygon = std::get_if<Polygon>(&shape);
  if (polygon != nullptr && dimension == 3) {
    for (const double place : {polygon->from, polygon->to})
      if (const auto cut = cut_between(box, static_cast<std::size_t>(polygon->axis), place))
        return cut;
  }
  return {};
}

/// What decides in a box.
struct Undecided {
  std::vector<const Shape*> cut;  ///< parts whose surface is there
  bool subtracted = false;        ///< the only one is taken away from what fills the box
};
Undecided undecided_in(const Combination& combination, const Box& box, int dimension) {
  Undecided left;
  for (std::size_t i = 0; i < combination.parts.size(); ++i) {
    if (side_of(combination.parts[i], box, dimension) != Side::cut) continue;
    left.cut.push_back(&combination.parts[i]);
    left.subtracted = combination.operation == Operation::subtract && i > 0;
  }
  return left;
}

/// Counted at the middles of 4 parts per direction.
Piece count_points(const Combination& combination, const Box& box, int dimension) {
  constexpr int n = 4;
  Piece sum;
  const Piece all = whole(box, dimension);
  const int total = dimension == 2 ? n * n : n * n * n;
  for (int k = 0; k < total; ++k) {
    Vector x = all.centroid;
    int rest = k;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i, rest /= n)
      x[i] = box.lower[i] + (rest % n + 0.5) / n * (box.upper[i] - box.lower[i]);
    if (holds(combination, x, dimension)) add(sum, {all.measure / total, x});
  }
  return sum;
}

Piece piece_in(const Shape& shape, const Box& box, int dimension, int splits) {
  const auto* combination = std::get_if<Combination>(&shape);
  return combination == nullptr ? piece_of(shape, box, dimension)
                                : piece_of_combination(*combination, box, dimension, splits);
}

Piece piece_of_halves(
    const Combination& combination, const Box& box, const Cut& cut, int dimension, int splits
) {
  Box below = box, above = box;
  below.upper[cut.axis] = above.lower[cut.axis] = cut.place;
  Piece sum = piece_of_combination(combination, below, dimension, splits);
  add(sum, piece_of_combination(combination, above, dimension, splits));
  return sum;
}

}  // namespace

bool holds(const Combination& combination, const Vector& x, int dimension) {
  const auto in = [&](const Shape& part) { return holds(part, x, dimension); };
  const auto& parts = combination.parts;
  if (combination.operation == Operation::unite) return std::any_of(parts.begin(), parts.end(), in);
  if (combination.operation == Operation::intersect)
    return std::all_of(parts.begin(), parts.end(), in);
  return in(parts.front()) && std::none_of(parts.begin() + 1, parts.end(), in);
}

Side side_of(const Combination& combination, const Box& box, int dimension) {
  const auto& parts = combination.parts;
  std::size_t inside = 0, outside = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Side part = side_of(parts[i], box, dimension);
    if (combination.operation == Operation::subtract && i > 0 && part != Side::cut)
      part = part == Side::inside ? Side::outside : Side::inside;
    inside += part == Side::inside ? 1U : 0U;
    outside += part == Side::outside ? 1U : 0U;
  }
  const bool unite = combination.operation == Operation::unite;
  if (unite ? inside > 0 : inside == parts.size()) return Side::inside;
  if (unite ? outside == parts.size() : outside > 0) return Side::outside;
  return Side::cut;
}

Piece piece_of_combination(
    const Combination& combination, const Box& box, int dimension, int splits
) {
  const Side side = side_of(combination, box, dimension);
  if (side == Side::outside) return {};
  if (side == Side::inside) return whole(box, dimension);
  const Undecided left = undecided_in(combination, box, dimension);
  if (left.cut.size() == 1) {
    const Piece piece = piece_in(*left.cut[0], box, dimension, splits);
    return left.subtracted ? rest_of(box, piece, dimension) : piece;
  }
  for (const Shape* part : left.cut)
    if (const auto cut = flat_side(*part, box, dimension))
      return piece_of_halves(combination, box, *cut, dimension, splits);
  if (splits == 0) return count_points(combination, box, dimension);
  Piece sum;
  for_each_half(box, dimension, [&](const Box& half) {
    add(sum, piece_of_combination(combination, half, dimension, splits - 1));
  });
  return sum;
}

}  // namespace barreno
