// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/piece.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using Point = std::array<double, 2>;

/// The two coordinates of the plane that a polygon is drawn in.
std::array<std::size_t, 2> plane_of(int axis) {
  if (axis == 0) return {1, 2};
  return {0, axis == 1 ? 2U : 1U};
}

/// Area and first moments about the lower corner of a rectangle.
struct Moments {
  double area = 0.0, x = 0.0, y = 0.0;
};

/// Between the x-axis and a line from a to b, counted with the sign of b - a along x.
void add_strip(const Point& a, const Point& b, Moments& m) {
  const double dx = b[0] - a[0];
  m.area += 0.5 * dx * (a[1] + b[1]);
  m.x += dx / 6.0 * (a[0] * (2.0 * a[1] + b[1]) + b[0] * (a[1] + 2.0 * b[1]));
  m.y += dx / 6.0 * (a[1] * a[1] + a[1] * b[1] + b[1] * b[1]);
}

Point between(const Point& a, const Point& b, double s) {
  return {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
}

/// What lies below an edge in the rectangle [0, width] x [0, height].
void add_below_edge(const Point& a, const Point& b, double width, double height, Moments& m) {
  if (std::max(a[0], b[0]) <= 0.0 || std::min(a[0], b[0]) >= width || a[0] == b[0]) return;
  std::array<double, 4> breaks{0.0, 1.0, 0.0, 1.0};
  const auto part = [](double from, double to, double place) {
    return from == to ? 0.0 : std::clamp((place - from) / (to - from), 0.0, 1.0);
  };
  breaks[0] = part(a[0], b[0], 0.0);
  breaks[1] = part(a[0], b[0], width);
  if (breaks[0] > breaks[1]) std::swap(breaks[0], breaks[1]);
  breaks[2] = std::clamp(part(a[1], b[1], 0.0), breaks[0], breaks[1]);
  breaks[3] = std::clamp(part(a[1], b[1], height), breaks[0], breaks[1]);
  std::sort(breaks.begin(), breaks.end());
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (!(breaks[k + 1] > breaks[k])) continue;
    Point from = between(a, b, breaks[k]), to = between(a, b, breaks[k + 1]);
    for (Point* p : {&from, &to}) {
      (*p)[0] = std::clamp((*p)[0], 0.0, width);
      (*p)[1] = std::clamp((*p)[1], 0.0, height);
    }
    add_strip(from, to, m);
  }
}

/// A line from a to b comes into the rectangle.
bool meets(const Point& a, const Point& b, const Point& lower, const Point& upper) {
  for (std::size_t i = 0; i < 2; ++i)
    if (std::max(a[i], b[i]) < lower[i] || std::min(a[i], b[i]) > upper[i]) return false;
  // On which side of the line the corners are.
  int left = 0, right = 0;
  for (const double x : {lower[0], upper[0]})
    for (const double y : {lower[1], upper[1]}) {
      const double turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      if (turn > 0.0) ++left;
      if (turn < 0.0) ++right;
    }
  return left < 4 && right < 4;
}

}  // namespace

int crossing(const Point& a, const Point& b, const Point& x) {
  if ((a[1] <= x[1]) == (b[1] <= x[1])) return 0;
  // The same numbers for both directions of an edge.
  const bool up = a[1] < b[1];
  const Point &low = up ? a : b, &high = up ? b : a;
  const double turn = (high[0] - low[0]) * (x[1] - low[1]) - (high[1] - low[1]) * (x[0] - low[0]);
  if (!(turn > 0.0)) return 0;
  return up ? 1 : -1;
}

bool holds(const Polygon& polygon, const Vector& x, int dimension) {
  const auto axis = static_cast<std::size_t>(polygon.axis);
  if (dimension == 3 && !(x[axis] >= polygon.from && x[axis] < polygon.to)) return false;
  const auto plane = plane_of(polygon.axis);
  int winding = 0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Point& next = polygon.corners[(i + 1) % polygon.corners.size()];
    winding += crossing(polygon.corners[i], next, {x[plane[0]], x[plane[1]]});
  }
  return winding != 0;
}

Side side_of_polygon(const Polygon& polygon, const Box& box, int dimension) {
  const auto axis = static_cast<std::size_t>(polygon.axis);
  if (dimension == 3 && (box.upper[axis] <= polygon.from || box.lower[axis] >= polygon.to))
    return Side::outside;
  const auto plane = plane_of(polygon.axis);
  const Point lower{box.lower[plane[0]], box.lower[plane[1]]};
  const Point upper{box.upper[plane[0]], box.upper[plane[1]]};
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Point& next = polygon.corners[(i + 1) % polygon.corners.size()];
    if (meets(polygon.corners[i], next, lower, upper)) return Side::cut;
  }
  Vector middle{};
  for (std::size_t i = 0; i < 3; ++i) middle[i] = 0.5 * (box.lower[i] + box.upper[i]);
  if (!holds(polygon, middle, 2)) return Side::outside;
  const bool between_ends =
      dimension == 2 || (box.lower[axis] >= polygon.from && box.upper[axis] <= polygon.to);
  return between_ends ? Side::inside : Side::cut;
}

/// Green's theorem with every edge clipped to the rectangle: the area below it, signed by its
/// direction.
Piece piece_of_polygon(const Polygon& polygon, const Box& box, int dimension) {
  const auto plane = plane_of(polygon.axis);
  const auto axis = static_cast<std::size_t>(polygon.axis);
  const double width = box.upper[plane[0]] - box.lower[plane[0]];
  const double height = box.upper[plane[1]] - box.lower[plane[1]];
  const auto local = [&](const Point& p) -> Point {
    return {p[0] - box.lower[plane[0]], p[1] - box.lower[plane[1]]};
  };
  Moments m;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Point& next = polygon.corners[(i + 1) % polygon.corners.size()];
    add_below_edge(local(polygon.corners[i]), local(next), width, height, m);
  }
  // Less than this is round-off.
  constexpr double least = 1e-12;
  if (!(std::abs(m.area) > least * width * height)) return {};
  Piece piece{std::abs(m.area), {}};
  piece.centroid[plane[0]] = box.lower[plane[0]] + m.x / m.area;
  piece.centroid[plane[1]] = box.lower[plane[1]] + m.y / m.area;
  if (dimension == 2) return piece;
  const double from = std::max(box.lower[axis], polygon.from);
  const double to = std::min(box.upper[axis], polygon.to);
  if (!(to > from)) return {};
  piece.measure *= to - from;
  piece.centroid[axis] = 0.5 * (from + to);
  return piece;
}

}  // namespace barreno
