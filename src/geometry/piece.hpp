// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/shape.hpp"

namespace barreno {

/// What a shape fills of a box: area in two dimensions, volume in three, and its centroid.
struct Piece {
  double measure = 0.0;  ///< [length^dimension]
  Vector centroid{};
};

/// Where a box lies: `cut` may also be said of a box that the surface only comes near.
enum class Side { outside, cut, inside };

/// The point is inside. Surfaces that share their corners share no point.
bool holds(const Shape& shape, const Vector& x, int dimension);

/// The box lies inside, outside, or is cut.
Side side_of(const Shape& shape, const Box& box, int dimension);

/// The part of a box that is inside a shape.
///
/// Exact to round-off for boxes, polygons, facets, disks, half planes; to 1e-10 of the box for
/// balls, and for cones along an axis of the coordinates; to 1e-7 for half-spaces. A cone in
/// another direction is cut into `cone_parts`^3 boxes, each of which sees a plane: second order in
/// their size. Combinations are as exact as their parts where the surface of one of them cuts the
/// box, and wherever boxes meet; where other surfaces meet, the box is divided until one is left in
/// each, at most `splits_2d` or `splits_3d` times in halves, and the rest is counted at 4 points
/// per direction.
Piece piece_of(const Shape& shape, const Box& box, int dimension);

/// The smallest box around a shape; infinite where the shape is.
Box box_around(const Shape& shape);

/// Area or volume, exact for single shapes; an upper bound for combinations, infinite for
/// half-spaces.
double measure_bound(const Shape& shape, int dimension);

/// All pieces of a shape are exact to 1e-7 of their box at least.
bool has_exact_pieces(const Shape& shape);

/// Part of a box by which a flat surface may miss its face and still lie on it: round-off of the
/// coordinates, far below what pieces are exact to.
inline constexpr double face_margin = 1e-11;
inline constexpr int splits_2d = 6, splits_3d = 3, cone_splits = 3;

// What the above are made of.

/// Area or volume of a box.
double measure_of(const Box& box, int dimension);
Piece whole(const Box& box, int dimension);
/// Two pieces that share nothing become one.
void add(Piece& sum, const Piece& piece);
/// The box without a piece of it.
Piece rest_of(const Box& box, const Piece& piece, int dimension);
/// `visit(part)` for the 2^dimension halves of a box.
template <class Visit>
void for_each_half(const Box& box, int dimension, Visit&& visit) {
  for (unsigned part = 0; part < (1U << static_cast<unsigned>(dimension)); ++part) {
    Box half = box;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
      const double middle = 0.5 * (box.lower[i] + box.upper[i]);
      ((part >> i & 1U) != 0U ? half.lower : half.upper)[i] = middle;
    }
    visit(half);
  }
}

Piece piece_of_ball(const Ball& ball, const Box& box, int dimension);
Piece piece_of_cone(const Cone& cone, const Box& box);
Piece piece_of_polygon(const Polygon& polygon, const Box& box, int dimension);
Piece piece_of_half_space(const HalfSpace& half, const Box& box, int dimension);
Piece piece_of_combination(
    const Combination& combination, const Box& box, int dimension, int splits
);

Side side_of_cone(const Cone& cone, const Box& box);
Side side_of(const Combination& combination, const Box& box, int dimension);
bool holds(const Combination& combination, const Vector& x, int dimension);
bool holds(const Cone& cone, const Vector& x);

/// Of a cone's surface, negative inside [length].
double distance_to(const Cone& cone, const Vector& x);

Side side_of_polygon(const Polygon& polygon, const Box& box, int dimension);
bool holds(const Polygon& polygon, const Vector& x, int dimension);

/// How often the directed edge from a to b winds around x when seen in the plane: -1, 0 or 1
/// crossings of the ray from x along the first coordinate. Exactly opposite for the opposite edge,
/// so that figures with a common edge neither overlap nor leave a gap.
int crossing(
    const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& x
);

}  // namespace barreno
