// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/arc.hpp"

#include "base/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using Point = std::array<double, 2>;

/// Twice the area of the triangle between two vectors, signed.
double turn_between(const Point& u, const Point& v) {
  return u[0] * v[1] - u[1] * v[0];
}

double square_of(const Point& u) {
  return u[0] * u[0] + u[1] * u[1];
}

/// Of the square of their distances: with less the points lie on a line, as well as a centre that
/// far away can be told.
constexpr double least_turn = 1e-6;

/// Distance from the centre of the corners between the ends, with which n chords of this angle
/// enclose as much as the arc: two triangles with one corner on the circle, n - 2 with none.
double radius_of_corners(double radius, int chords, double angle) {
  const double n = chords, arc = n * radius * radius * angle / std::sin(angle);
  return (std::sqrt(radius * radius + (n - 2.0) * arc) - radius) / (n - 2.0);
}

std::vector<Point> corners_from(const Point& a, const Point& through, const Point& b) {
  const Point u{through[0] - a[0], through[1] - a[1]}, v{b[0] - a[0], b[1] - a[1]};
  const double turn = turn_between(u, v);
  if (!(std::abs(turn) > least_turn * std::max(square_of(u), square_of(v)))) return {};
  const Point to_centre{
      0.5 * (v[1] * square_of(u) - u[1] * square_of(v)) / turn,
      0.5 * (u[0] * square_of(v) - v[0] * square_of(u)) / turn};
  const Point centre{a[0] + to_centre[0], a[1] + to_centre[1]};
  const double start = std::atan2(-to_centre[1], -to_centre[0]);
  // From a over the point to b it turns to the left as the triangle does.
  double sweep = std::atan2(b[1] - centre[1], b[0] - centre[0]) - start;
  if (turn > 0.0 && sweep < 0.0) sweep += two_pi;
  if (turn < 0.0 && sweep > 0.0) sweep -= two_pi;

  constexpr double round_off = 1e-9;
  const double needed = std::ceil(std::abs(sweep) / longest_chord - round_off);
  const int chords = std::max(fewest_chords, static_cast<int>(needed));
  const double angle = sweep / chords;
  const double radius = radius_of_corners(std::sqrt(square_of(to_centre)), chords, angle);
  std::vector<Point> corners;
  corners.reserve(static_cast<std::size_t>(chords) - 1);
  for (int i = 1; i < chords; ++i)
    corners.push_back(
        {centre[0] + radius * std::cos(start + i * angle),
         centre[1] + radius * std::sin(start + i * angle)}
    );
  return corners;
}

}  // namespace

std::vector<Point> corners_of_arc(const Point& a, const Point& through, const Point& b) {
  if (!(b < a)) return corners_from(a, through, b);
  std::vector<Point> corners = corners_from(b, through, a);
  std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace barreno
