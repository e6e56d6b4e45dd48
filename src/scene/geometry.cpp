// SPDX-License-Identifier: BSD-3-Clause
#include "scene/geometry.hpp"

#include "base/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// The axis halves a ball that is centred on it.
bool on_axis(const Ball& ball, const GridSpec& grid) {
  return grid.mode == Mode::axisymmetric && ball.centre[0] == 0.0;
}

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

bool overlap(const Box& a, const Box& b, double tolerance) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::min(a.upper[i], b.upper[i]) - std::max(a.lower[i], b.lower[i]) <= tolerance)
      return false;
  }
  return true;
}
bool overlap(const Box& box, const Ball& ball, double tolerance) {
  Vector nearest{};
  for (std::size_t i = 0; i < 2; ++i)
    nearest[i] = std::clamp(ball.centre[i], box.lower[i], box.upper[i]);
  return distance(nearest, ball.centre) < ball.radius - tolerance;
}
bool overlap(const Ball& ball, const Box& box, double tolerance) {
  return overlap(box, ball, tolerance);
}
bool overlap(const Ball& a, const Ball& b, double tolerance) {
  return distance(a.centre, b.centre) < a.radius + b.radius - tolerance;
}

}  // namespace

double touching(const GridSpec& grid) {
  return 1e-6 * grid.cell_size;
}

Box box_around(const Shape& shape, const GridSpec& grid) {
  if (const auto* box = std::get_if<Box>(&shape)) return *box;
  const auto& ball = std::get<Ball>(shape);
  Box box;
  for (std::size_t i = 0; i < 2; ++i) {
    box.lower[i] = ball.centre[i] - ball.radius;
    box.upper[i] = ball.centre[i] + ball.radius;
  }
  if (on_axis(ball, grid)) box.lower[0] = 0.0;
  return box;
}

double area_of(const Shape& shape, const GridSpec& grid) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    return (box->upper[0] - box->lower[0]) * (box->upper[1] - box->lower[1]);
  }
  const auto& ball = std::get<Ball>(shape);
  return (on_axis(ball, grid) ? 0.5 : 1.0) * pi * ball.radius * ball.radius;
}

bool overlap(const Shape& a, const Shape& b, const GridSpec& grid) {
  const double tolerance = touching(grid);
  return std::visit([&](const auto& x, const auto& y) { return overlap(x, y, tolerance); }, a, b);
}

bool inside(const Shape& shape, const GridSpec& grid) {
  const Box box = box_around(shape, grid);
  const double tolerance = touching(grid);
  for (std::size_t i = 0; i < 2; ++i) {
    if (box.lower[i] < grid.lower[i] - tolerance || box.upper[i] > grid.upper[i] + tolerance)
      return false;
  }
  return true;
}

}  // namespace barreno
