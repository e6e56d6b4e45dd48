// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "geometry/piece.hpp"
#include "geometry/surface.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

const Box everywhere{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};

Box around(const Box& box) {
  return box;
}
Box around(const Ball& ball) {
  Box box{ball.centre, ball.centre};
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] -= ball.radius;
    box.upper[i] += ball.radius;
  }
  return box;
}
Box around(const Cone& cone) {
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) square += std::pow(cone.end[i] - cone.start[i], 2);
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    // Share of a disk's radius along i.
    const double share =
        std::sqrt(std::max(0.0, 1.0 - std::pow(cone.end[i] - cone.start[i], 2) / square));
    const double start = cone.start_radius * share, end = cone.end_radius * share;
    box.lower[i] = std::min(cone.start[i] - start, cone.end[i] - end);
    box.upper[i] = std::max(cone.start[i] + start, cone.end[i] + end);
  }
  return box;
}
Box around(const Polygon& polygon) {
  const auto axis = static_cast<std::size_t>(polygon.axis);
  const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  Box box;
  box.lower[axis] = polygon.from;
  box.upper[axis] = polygon.to;
  box.lower[first] = box.lower[second] = infinity;
  box.upper[first] = box.upper[second] = -infinity;
  for (const auto& corner : polygon.corners) {
    box.lower[first] = std::min(box.lower[first], corner[0]);
    box.upper[first] = std::max(box.upper[first], corner[0]);
    box.lower[second] = std::min(box.lower[second], corner[1]);
    box.upper[second] = std::max(box.upper[second], corner[1]);
  }
  return box;
}
Box around(const HalfSpace& half) {
  Box box = everywhere;
  for (std::size_t i = 0; i < 3; ++i) {
    if (half.normal[i] >= 1.0) box.upper[i] = half.point[i];
    if (half.normal[i] <= -1.0) box.lower[i] = half.point[i];
  }
  return box;
}
Box around(const Faceted& faceted) {
  return faceted.surface->around();
}
Box around(const Combination& combination) {
  Box box = box_around(combination.parts.front());
  if (combination.operation == Operation::subtract) return box;
  const bool unite = combination.operation == Operation::unite;
  for (const Shape& part : combination.parts) {
    const Box own = box_around(part);
    for (std::size_t i = 0; i < 3; ++i) {
      box.lower[i] =
          unite ? std::min(box.lower[i], own.lower[i]) : std::max(box.lower[i], own.lower[i]);
      box.upper[i] =
          unite ? std::max(box.upper[i], own.upper[i]) : std::min(box.upper[i], own.upper[i]);
    }
  }
  return box;
}

double bound(const Box& box, int dimension) {
  return measure_of(box, dimension);
}
double bound(const Ball& ball, int dimension) {
  if (dimension == 2)
    return pi * (ball.radius * ball.radius - ball.inner_radius * ball.inner_radius);
  return 4.0 / 3.0 * pi * (std::pow(ball.radius, 3) - std::pow(ball.inner_radius, 3));
}
double bound(const Cone& cone, int /*dimension*/) {
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) square += std::pow(cone.end[i] - cone.start[i], 2);
  const double a = cone.start_radius, b = cone.end_radius;
  return pi * std::sqrt(square) *
         ((a * a + a * b + b * b) / 3.0 - cone.inner_radius * cone.inner_radius);
}
double bound(const Polygon& polygon, int dimension) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const auto &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
  }
  return std::abs(area) * (dimension == 2 ? 1.0 : polygon.to - polygon.from);
}
double bound(const HalfSpace& /*half*/, int /*dimension*/) {
  return infinity;
}
double bound(const Faceted& faceted, int /*dimension*/) {
  return faceted.surface->volume();
}
double bound(const Combination& combination, int dimension) {
  double sum = 0.0, least = infinity;
  for (const Shape& part : combination.parts) {
    const double own = measure_bound(part, dimension);
    sum += own;
    least = std::min(least, own);
  }
  if (combination.operation == Operation::unite) return sum;
  if (combination.operation == Operation::intersect) return least;
  return measure_bound(combination.parts.front(), dimension);
}

}  // namespace

Box box_around(const Shape& shape) {
  return std::visit([](const auto& own) { return around(own); }, shape);
}

double measure_bound(const Shape& shape, int dimension) {
  return std::visit([&](const auto& own) { return bound(own, dimension); }, shape);
}

bool has_exact_pieces(const Shape& shape) {
  if (const auto* combination = std::get_if<Combination>(&shape))
    return std::all_of(combination->parts.begin(), combination->parts.end(), [](const Shape& part) {
      return std::holds_alternative<Box>(part);
    });
  const auto* cone = std::get_if<Cone>(&shape);
  if (cone == nullptr) return true;
  int along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += cone->start[i] != cone->end[i] ? 1 : 0;
  return along == 1;
}

}  // namespace barreno
