// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/slices.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace barreno {

std::optional<Round> round_of(const Cone& cone) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    if (cone.start[first] != cone.end[first] || cone.start[second] != cone.end[second]) continue;
    const bool up = cone.end[axis] > cone.start[axis];
    return Round{
        cone.start,
        axis,
        std::min(cone.start[axis], cone.end[axis]),
        std::max(cone.start[axis], cone.end[axis]),
        up ? cone.start_radius : cone.end_radius,
        up ? cone.end_radius : cone.start_radius};
  }
  return {};
}

namespace {

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A point in the half plane through the axis: along it, and away from it.
struct Meridian {
  double along = 0.0, away = 0.0;
};

double length_of(const Cone& cone) {
  // Squares of what a deck may say overflow.
  return std::hypot(
      cone.end[0] - cone.start[0], cone.end[1] - cone.start[1], cone.end[2] - cone.start[2]
  );
}

Meridian meridian_of(const Cone& cone, double length, const Vector& x) {
  Vector axis{}, arm{};
  for (std::size_t i = 0; i < 3; ++i) {
    axis[i] = cone.end[i] - cone.start[i];
    arm[i] = x[i] - cone.start[i];
  }
  const double along = dot(arm, axis) / length;
  double away = 0.0;
  for (std::size_t i = 0; i < 3; ++i) away += std::pow(arm[i] - along * axis[i] / length, 2);
  return {along, std::sqrt(away)};
}

bool is_inside(const Cone& cone, double length, const Meridian& p) {
  const double radius =
      cone.start_radius + (cone.end_radius - cone.start_radius) * p.along / length;
  return p.along > 0.0 && p.along < length && p.away < radius && p.away >= cone.inner_radius;
}

double distance_to_line(const Meridian& p, const Meridian& a, const Meridian& b) {
  const double dx = b.along - a.along, dy = b.away - a.away;
  const double square = dx * dx + dy * dy;
  double s = 0.0;
  if (square > 0.0)
    s = std::clamp(((p.along - a.along) * dx + (p.away - a.away) * dy) / square, 0.0, 1.0);
  return std::hypot(p.along - a.along - s * dx, p.away - a.away - s * dy);
}

/// Least and greatest distance of a box's points from the axis.
struct Distances {
  double least, greatest;
};
Distances distances_to_axis(const Round& round, const Box& box) {
  double near = 0.0, far = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == round.axis) continue;
    const double below = box.lower[i] - round.centre[i], above = box.upper[i] - round.centre[i];
    const double beside = std::max({below, -above, 0.0});
    near += beside * beside;
    far += std::max(below * below, above * above);
  }
  return {std::sqrt(near), std::sqrt(far)};
}

Side side_of_round(const Round& round, double bore, const Box& box) {
  const double lower = box.lower[round.axis], upper = box.upper[round.axis];
  const double margin = face_margin * (upper - lower);
  if (upper <= round.from + margin || lower >= round.to - margin) return Side::outside;
  const auto radius = [&](double place) {
    const double part = (place - round.from) / (round.to - round.from);
    return round.radius_from + part * (round.radius_to - round.radius_from);
  };
  const double first = radius(std::max(lower, round.from));
  const double last = radius(std::min(upper, round.to));
  const Distances away = distances_to_axis(round, box);
  if (away.least >= std::max(first, last) || away.greatest <= bore) return Side::outside;
  const bool inside = lower >= round.from - margin && upper <= round.to + margin &&
                      away.greatest <= std::min(first, last) && away.least >= bore;
  return inside ? Side::inside : Side::cut;
}

/// Volume and first moments without the bore, turned to a piece.
Piece piece_of_round(const Cone& cone, Round round, const Box& box) {
  const Piece body = slice_round(round, box);
  Piece bore;
  if (cone.inner_radius > 0.0) {
    round.radius_from = round.radius_to = cone.inner_radius;
    bore = slice_round(round, box);
  }
  const double measure = body.measure - bore.measure;
  constexpr double least = 1e-9;  // of the box: round-off of the difference
  if (!(measure > least * measure_of(box, 3))) return {};
  Piece piece{measure, {}};
  for (std::size_t i = 0; i < 3; ++i)
    piece.centroid[i] = round.centre[i] + (body.centroid[i] - bore.centroid[i]) / measure;
  return piece;
}

/// The plane that the surface nearest to a point is taken for.
HalfSpace plane_near(const Cone& cone, const Vector& x, double reach) {
  HalfSpace plane;
  double length = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector ahead = x, behind = x;
    ahead[i] += 1e-3 * reach;
    behind[i] -= 1e-3 * reach;
    plane.normal[i] = distance_to(cone, ahead) - distance_to(cone, behind);
    length += plane.normal[i] * plane.normal[i];
  }
  const double distance = distance_to(cone, x);
  for (std::size_t i = 0; i < 3; ++i) {
    plane.normal[i] /= std::max(std::sqrt(length), 1e-300);
    plane.point[i] = x[i] - distance * plane.normal[i];
  }
  return plane;
}

double half_diagonal(const Box& box) {
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) square += std::pow(box.upper[i] - box.lower[i], 2);
  return 0.5 * std::sqrt(square);
}

Piece piece_of_oblique(const Cone& cone, const Box& box, int splits) {
  const Piece all = whole(box, 3);
  const double distance = distance_to(cone, all.centroid), reach = half_diagonal(box);
  if (distance >= reach) return {};
  if (distance <= -reach) return all;
  if (splits == 0) return piece_of_half_space(plane_near(cone, all.centroid, reach), box, 3);
  Piece sum;
  for_each_half(box, 3, [&](const Box& half) {
    add(sum, piece_of_oblique(cone, half, splits - 1));
  });
  return sum;
}

}  // namespace

double distance_to(const Cone& cone, const Vector& x) {
  const double length = length_of(cone), bore = cone.inner_radius;
  const Meridian p = meridian_of(cone, length, x);
  const Meridian a{0.0, bore}, b{0.0, cone.start_radius}, c{length, cone.end_radius},
      d{length, bore};
  double distance =
      std::min({distance_to_line(p, a, b), distance_to_line(p, b, c), distance_to_line(p, c, d)});
  if (bore > 0.0) distance = std::min(distance, distance_to_line(p, d, a));
  return is_inside(cone, length, p) ? -distance : distance;
}

bool holds(const Cone& cone, const Vector& x) {
  const double length = length_of(cone);
  return is_inside(cone, length, meridian_of(cone, length, x));
}

Side side_of_cone(const Cone& cone, const Box& box) {
  if (const auto round = round_of(cone)) return side_of_round(*round, cone.inner_radius, box);
  const double distance = distance_to(cone, whole(box, 3).centroid);
  if (std::abs(distance) < half_diagonal(box)) return Side::cut;
  return distance < 0.0 ? Side::inside : Side::outside;
}

Piece piece_of_cone(const Cone& cone, const Box& box) {
  if (const auto round = round_of(cone)) return piece_of_round(cone, *round, box);
  return piece_of_oblique(cone, box, cone_splits);
}

}  // namespace barreno
