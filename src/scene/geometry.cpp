// SPDX-License-Identifier: BSD-3-Clause
#include "scene/geometry.hpp"

#include "base/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// What touching shapes share, in the dimensions of the grid.
struct Sharing {
  std::size_t dimensions;
  double tolerance;
};

bool overlap(const Box& a, const Box& b, const Sharing& sharing) {
  const double tolerance = sharing.tolerance;
  for (std::size_t i = 0; i < sharing.dimensions; ++i) {
    if (std::min(a.upper[i], b.upper[i]) - std::max(a.lower[i], b.lower[i]) <= tolerance)
      return false;
  }
  return true;
}
bool overlap(const Box& box, const Ball& ball, const Sharing& sharing) {
  const double tolerance = sharing.tolerance;
  Vector nearest{};
  for (std::size_t i = 0; i < 2; ++i)
    nearest[i] = std::clamp(ball.centre[i], box.lower[i], box.upper[i]);
  Vector farthest{};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool lower = ball.centre[i] - box.lower[i] > box.upper[i] - ball.centre[i];
    farthest[i] = lower ? box.lower[i] : box.upper[i];
  }
  const bool in_hollow = distance(farthest, ball.centre) <= ball.inner_radius + tolerance;
  return distance(nearest, ball.centre) < ball.radius - tolerance && !in_hollow;
}
bool overlap(const Ball& ball, const Box& box, const Sharing& sharing) {
  return overlap(box, ball, sharing);
}
/// One is in the other's hollow.
bool in_hollow(const Ball& inner, const Ball& outer, double tolerance) {
  return distance(inner.centre, outer.centre) + inner.radius <= outer.inner_radius + tolerance;
}
bool overlap(const Ball& a, const Ball& b, const Sharing& sharing) {
  const double tolerance = sharing.tolerance;
  return distance(a.centre, b.centre) < a.radius + b.radius - tolerance &&
         !in_hollow(a, b, tolerance) && !in_hollow(b, a, tolerance);
}

}  // namespace

double touching(const GridSpec& grid) {
  return 1e-6 * grid.cell_size;
}

std::vector<Face> cutting_faces(const Ball& ball, const GridSpec& grid) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < 2; ++i) {
    for (const bool upper : {false, true}) {
      const double place = (upper ? grid.upper : grid.lower)[i];
      if (std::abs(ball.centre[i] - place) <= touching(grid))
        faces.push_back(static_cast<Face>(2 * i + (upper ? 1 : 0)));
    }
  }
  return faces;
}

Box box_around(const Shape& shape, const GridSpec& grid) {
  if (const auto* box = std::get_if<Box>(&shape)) return *box;
  const auto& ball = std::get<Ball>(shape);
  Box box;
  for (std::size_t i = 0; i < 2; ++i) {
    box.lower[i] = ball.centre[i] - ball.radius;
    box.upper[i] = ball.centre[i] + ball.radius;
  }
  for (const Face face : cutting_faces(ball, grid)) {
    const auto i = static_cast<std::size_t>(face) / 2;
    const bool upper = static_cast<std::size_t>(face) % 2 == 1;
    (upper ? box.upper : box.lower)[i] = (upper ? grid.upper : grid.lower)[i];
  }
  return box;
}

double area_of(const Shape& shape, const GridSpec& grid) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    double area = 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i)
      area *= box->upper[i] - box->lower[i];
    return area;
  }
  const auto& ball = std::get<Ball>(shape);
  const double whole = pi * (ball.radius * ball.radius - ball.inner_radius * ball.inner_radius);
  return std::ldexp(whole, -static_cast<int>(cutting_faces(ball, grid).size()));
}

bool overlap(const Shape& a, const Shape& b, const GridSpec& grid) {
  const Sharing sharing{static_cast<std::size_t>(dimensions(grid.mode)), touching(grid)};
  return std::visit([&](const auto& x, const auto& y) { return overlap(x, y, sharing); }, a, b);
}

bool inside(const Shape& shape, const GridSpec& grid) {
  const Box box = box_around(shape, grid);
  const double tolerance = touching(grid);
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    if (box.lower[i] < grid.lower[i] - tolerance || box.upper[i] > grid.upper[i] + tolerance)
      return false;
  }
  return true;
}

}  // namespace barreno
