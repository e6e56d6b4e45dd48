// SPDX-License-Identifier: BSD-3-Clause
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace barreno {
namespace {

/// Exact tests of boxes and balls; what is closer than the tolerance touches.
bool overlap(const Box& a, const Box& b, std::size_t dimension, double tolerance) {
  for (std::size_t i = 0; i < dimension; ++i) {
    if (std::min(a.upper[i], b.upper[i]) - std::max(a.lower[i], b.lower[i]) <= tolerance)
      return false;
  }
  return true;
}
bool overlap(const Box& box, const Ball& ball, std::size_t dimension, double tolerance) {
  Vector nearest = ball.centre, farthest = ball.centre;
  for (std::size_t i = 0; i < dimension; ++i) {
    nearest[i] = std::clamp(ball.centre[i], box.lower[i], box.upper[i]);
    const bool lower = ball.centre[i] - box.lower[i] > box.upper[i] - ball.centre[i];
    farthest[i] = lower ? box.lower[i] : box.upper[i];
  }
  const bool in_hollow = distance(farthest, ball.centre) <= ball.inner_radius + tolerance;
  return distance(nearest, ball.centre) < ball.radius - tolerance && !in_hollow;
}
/// One is in the other's hollow.
bool in_hollow(const Ball& inner, const Ball& outer, double tolerance) {
  return distance(inner.centre, outer.centre) + inner.radius <= outer.inner_radius + tolerance;
}
bool overlap(const Ball& a, const Ball& b, double tolerance) {
  return distance(a.centre, b.centre) < a.radius + b.radius - tolerance &&
         !in_hollow(a, b, tolerance) && !in_hollow(b, a, tolerance);
}

/// The line of a cone, or the centre of a ball twice.
struct Middle {
  Vector start{}, end{};
};
std::optional<Middle> middle_of(const Shape& shape) {
  if (const auto* ball = std::get_if<Ball>(&shape)) return Middle{ball->centre, ball->centre};
  if (const auto* cone = std::get_if<Cone>(&shape)) return Middle{cone->start, cone->end};
  return {};
}

}  // namespace

double length_tolerance(const GridSpec& grid) {
  return 1e-6 * grid.cell_size;
}

FaceList cutting_faces(const Shape& shape, const GridSpec& grid) {
  FaceList faces;
  const std::optional<Middle> middle = middle_of(shape);
  if (!middle) return faces;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    for (const bool upper : {false, true}) {
      const double place = (upper ? grid.upper : grid.lower)[i];
      if (std::abs(middle->start[i] - place) <= length_tolerance(grid) &&
          std::abs(middle->end[i] - place) <= length_tolerance(grid))
        faces.face[faces.count++] = static_cast<Face>(2 * i + (upper ? 1 : 0));
    }
  }
  return faces;
}

Box box_around(const Shape& shape, const GridSpec& grid) {
  Box box = box_around(shape);
  if (std::holds_alternative<Box>(shape)) return box;
  for (std::size_t i = 0; i < 3; ++i) {
    // A half-space fills the grid.
    if (!std::isfinite(box.lower[i])) box.lower[i] = grid.lower[i];
    if (!std::isfinite(box.upper[i])) box.upper[i] = grid.upper[i];
  }
  // The axis mirrors what is drawn across it; a polygon's corners must be at its side.
  if (grid.mode == Mode::axisymmetric && !std::holds_alternative<Polygon>(shape))
    box.lower[0] = std::max(box.lower[0], 0.0);
  for (const Face face : cutting_faces(shape, grid)) {
    const auto i = static_cast<std::size_t>(face) / 2;
    const bool upper = static_cast<std::size_t>(face) % 2 == 1;
    (upper ? box.upper : box.lower)[i] = (upper ? grid.upper : grid.lower)[i];
  }
  return box;
}

double max_measure(const Shape& shape, const GridSpec& grid) {
  const int dimension = dimensions(grid.mode);
  const double own = std::ldexp(
      measure_bound(shape, dimension), -static_cast<int>(cutting_faces(shape, grid).count)
  );
  const Box box = box_around(shape, grid);
  double around = 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    around *= std::max(0.0, box.upper[i] - box.lower[i]);
  return std::min(own, around);
}

Lattice lattice_of(const Shape& shape, const GridSpec& grid, double size) {
  return lattice_around(box_around(shape, grid), grid.lower, size, dimensions(grid.mode));
}

bool overlap(const Shape& a, const Shape& b, const GridSpec& grid, double spacing) {
  const double tolerance = length_tolerance(grid);
  const auto dimension = static_cast<std::size_t>(dimensions(grid.mode));
  const auto *box_a = std::get_if<Box>(&a), *box_b = std::get_if<Box>(&b);
  const auto *ball_a = std::get_if<Ball>(&a), *ball_b = std::get_if<Ball>(&b);
  if (box_a != nullptr && box_b != nullptr) return overlap(*box_a, *box_b, dimension, tolerance);
  if (box_a != nullptr && ball_b != nullptr) return overlap(*box_a, *ball_b, dimension, tolerance);
  if (ball_a != nullptr && box_b != nullptr) return overlap(*box_b, *ball_a, dimension, tolerance);
  if (ball_a != nullptr && ball_b != nullptr) return overlap(*ball_a, *ball_b, tolerance);
  Box common = box_around(a, grid);
  const Box other = box_around(b, grid);
  for (std::size_t i = 0; i < dimension; ++i) {
    common.lower[i] = std::max(common.lower[i], other.lower[i]);
    common.upper[i] = std::min(common.upper[i], other.upper[i]);
    if (common.upper[i] - common.lower[i] <= tolerance) return false;
  }
  return have_common_points(
      a,
      b,
      dimensions(grid.mode),
      lattice_around(common, grid.lower, spacing, dimensions(grid.mode))
  );
}

bool inside(const Shape& shape, const GridSpec& grid) {
  const Box box = box_around(shape, grid);
  const double tolerance = length_tolerance(grid);
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    if (box.lower[i] < grid.lower[i] - tolerance || box.upper[i] > grid.upper[i] + tolerance)
      return false;
  }
  return true;
}

}  // namespace barreno
