// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/piece.hpp"
#include "geometry/slices.hpp"
#include "geometry/surface.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

bool holds_point(const Box& box, const Vector& x, int dimension) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    if (!(x[i] >= box.lower[i] && x[i] < box.upper[i])) return false;
  return true;
}
bool holds_point(const Ball& ball, const Vector& x, int dimension) {
  double square = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    square += std::pow(x[i] - ball.centre[i], 2);
  return square < ball.radius * ball.radius && square >= ball.inner_radius * ball.inner_radius;
}
bool holds_point(const Cone& cone, const Vector& x, int /*dimension*/) {
  return holds(cone, x);
}
bool holds_point(const Polygon& polygon, const Vector& x, int dimension) {
  return holds(polygon, x, dimension);
}
bool holds_point(const HalfSpace& half, const Vector& x, int dimension) {
  double height = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    height += (x[i] - half.point[i]) * half.normal[i];
  return height < 0.0;
}
bool holds_point(const Faceted& faceted, const Vector& x, int /*dimension*/) {
  return faceted.surface->winding(x) > 0;
}
bool holds_point(const Combination& combination, const Vector& x, int dimension) {
  return holds(combination, x, dimension);
}

Side side(const Box& shape, const Box& box, int dimension) {
  bool inside = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    if (box.upper[i] <= shape.lower[i] || box.lower[i] >= shape.upper[i]) return Side::outside;
    inside = inside && box.lower[i] >= shape.lower[i] && box.upper[i] <= shape.upper[i];
  }
  return inside ? Side::inside : Side::cut;
}
Side side(const Ball& ball, const Box& box, int dimension) {
  return side_of(ball, box, dimension);
}
Side side(const Cone& cone, const Box& box, int /*dimension*/) {
  return side_of_cone(cone, box);
}
Side side(const Polygon& polygon, const Box& box, int dimension) {
  return side_of_polygon(polygon, box, dimension);
}
Side side(const HalfSpace& half, const Box& box, int dimension) {
  double middle = 0.0, reach = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    middle += (0.5 * (box.lower[i] + box.upper[i]) - half.point[i]) * half.normal[i];
    reach += 0.5 * (box.upper[i] - box.lower[i]) * std::abs(half.normal[i]);
  }
  if (middle >= (1.0 - face_margin) * reach) return Side::outside;
  return middle <= -(1.0 - face_margin) * reach ? Side::inside : Side::cut;
}
Side side(const Faceted& faceted, const Box& box, int /*dimension*/) {
  if (faceted.surface->comes_near(box)) return Side::cut;
  return faceted.surface->winding(whole(box, 3).centroid) > 0 ? Side::inside : Side::outside;
}
Side side(const Combination& combination, const Box& box, int dimension) {
  return side_of(combination, box, dimension);
}

Piece piece(const Box& shape, const Box& box, int dimension) {
  Box common = box;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    common.lower[i] = std::max(box.lower[i], shape.lower[i]);
    common.upper[i] = std::min(box.upper[i], shape.upper[i]);
    if (!(common.upper[i] > common.lower[i])) return {};
  }
  return whole(common, dimension);
}
Piece piece(const Ball& ball, const Box& box, int dimension) {
  return piece_of_ball(ball, box, dimension);
}
Piece piece(const Cone& cone, const Box& box, int /*dimension*/) {
  return piece_of_cone(cone, box);
}
Piece piece(const Polygon& polygon, const Box& box, int dimension) {
  return piece_of_polygon(polygon, box, dimension);
}
Piece piece(const HalfSpace& half, const Box& box, int dimension) {
  return piece_of_half_space(half, box, dimension);
}
Piece piece(const Faceted& faceted, const Box& box, int /*dimension*/) {
  return faceted.surface->piece_in(box);
}
Piece piece(const Combination& combination, const Box& box, int dimension) {
  return piece_of_combination(combination, box, dimension, dimension == 2 ? splits_2d : splits_3d);
}

}  // namespace

bool holds(const Shape& shape, const Vector& x, int dimension) {
  return std::visit([&](const auto& own) { return holds_point(own, x, dimension); }, shape);
}

Side side_of(const Shape& shape, const Box& box, int dimension) {
  return std::visit([&](const auto& own) { return side(own, box, dimension); }, shape);
}

Piece piece_of(const Shape& shape, const Box& box, int dimension) {
  const Side where = side_of(shape, box, dimension);
  if (where == Side::outside) return {};
  if (where == Side::inside) return whole(box, dimension);
  return std::visit([&](const auto& own) { return piece(own, box, dimension); }, shape);
}

}  // namespace barreno
