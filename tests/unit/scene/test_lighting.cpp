// SPDX-License-Identifier: BSD-3-Clause
/// Lighting times: of every kind of detonator, and around an inert ball, for which they are known.

#include "scene/lighting.hpp"
#include "scene/lighting_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace barreno {
namespace {

constexpr double pi = 3.14159265358979323846;

DetonatorSpec detonator(DetonatorKind kind, const Vector& position, double time = 0.0) {
  DetonatorSpec made;
  made.kind = kind;
  made.position = position;
  made.time = time;
  return made;
}

DetonationSpec detonation(const std::vector<DetonatorSpec>& detonators, double speed) {
  DetonationSpec made;
  made.detonators = detonators;
  made.speed = speed;
  return made;
}

TEST(StraightLighting, PointLineRingAndPlane) {
  const double speed = 2.0;
  const DetonatorSpec point = detonator(DetonatorKind::point, {1.0, 2.0, 2.0});
  DetonatorSpec line = detonator(DetonatorKind::line, {0.0, 0.0, 0.0});
  line.end = {0.0, 4.0, 0.0};
  DetonatorSpec ring = detonator(DetonatorKind::ring, {0.0, 1.0, 0.0});
  ring.radius = 3.0;
  ring.normal = {0.0, 1.0, 0.0};
  DetonatorSpec plane = detonator(DetonatorKind::plane, {0.0, 1.0, 5.0});
  plane.normal = {0.6, 0.8, 0.0};
  const auto time = [&](const DetonatorSpec& of, const Vector& x, Mode mode) {
    return straight_lighting_time(detonation({of}, speed), mode, x);
  };
  const Mode space = Mode::three_dimensional;
  EXPECT_DOUBLE_EQ(time(point, {0.0, 0.0, 0.0}, space), 1.5);
  EXPECT_DOUBLE_EQ(time(line, {3.0, 2.0, 4.0}, space), 2.5);  // beside it
  EXPECT_DOUBLE_EQ(time(line, {0.0, 7.0, 4.0}, space), 2.5);  // beyond its end
  EXPECT_DOUBLE_EQ(time(ring, {0.0, 1.0, 7.0}, space), 2.0);  // outside, in its plane
  EXPECT_DOUBLE_EQ(time(ring, {0.0, 5.0, 0.0}, space), 2.5);  // on its axis
  EXPECT_DOUBLE_EQ(time(ring, {7.0, 4.0, 0.0}, Mode::axisymmetric), 2.5);
  EXPECT_DOUBLE_EQ(time(plane, {3.0, 5.0, -2.0}, space), 2.5);
  EXPECT_DOUBLE_EQ(time(plane, {-3.0, -3.0, 9.0}, space), 2.5);  // on both sides
}

TEST(StraightLighting, TheFirstFrontLights) {
  const auto of = detonation(
      {detonator(DetonatorKind::point, {0.0, 0.0, 0.0}),
       detonator(DetonatorKind::point, {0.0, 10.0, 0.0}, 1.0)},
      2.0
  );
  EXPECT_DOUBLE_EQ(straight_lighting_time(of, Mode::axisymmetric, {0.0, 4.0, 0.0}), 2.0);
  EXPECT_DOUBLE_EQ(straight_lighting_time(of, Mode::axisymmetric, {0.0, 9.0, 0.0}), 1.5);
}

constexpr double ball = 3.0, speed = 2.0;
constexpr Vector lit_at{0.0, 5.0, 0.0};

/// The shortest way from lit_at to x that does not enter the ball about the origin: straight, or
/// along two tangents and an arc.
/// @par Source  Kenamond's problem 3: J. E. Owen et al., ExactPack, Los Alamos National Laboratory.
double time_around_ball(const Vector& x) {
  const double from = std::hypot(lit_at[0], lit_at[1]), to = std::hypot(x[0], x[1]);
  const double angle = std::acos((x[0] * lit_at[0] + x[1] * lit_at[1]) / (from * to));
  const double arc = angle - std::acos(ball / from) - std::acos(ball / to);
  if (arc <= 0.0) return std::hypot(x[0] - lit_at[0], x[1] - lit_at[1]) / speed;
  return (std::sqrt(from * from - ball * ball) + ball * arc + std::sqrt(to * to - ball * ball)) /
         speed;
}

/// Largest error over the half plane around the ball, with cells of size h.
double error_around_ball(double h) {
  GridSpec grid;
  grid.mode = Mode::axisymmetric;
  grid.lower = {0.0, -6.0, 0.0};
  grid.upper = {6.0, 6.0, 0.0};
  grid.cell_size = h;
  Combination around{Operation::subtract, {Box{grid.lower, grid.upper}, Ball{{}, ball, 0.0}}};
  auto of = detonation({detonator(DetonatorKind::point, lit_at)}, speed);
  const LightingMap map(grid, {around}, of);
  EXPECT_TRUE(map.reaches_all());
  double largest = 0.0;
  for (double r = ball + 0.01; r < 5.9; r += 0.173)
    for (double angle = 0.0; angle <= pi; angle += 0.0371) {
      const Vector x{r * std::sin(angle), r * std::cos(angle), 0.0};
      largest = std::max(largest, std::fabs(map.time_at(x) - time_around_ball(x)));
    }
  return largest;
}

/// Within 0.5 h / D, and first order or better.
TEST(LightingAroundObstacles, InertBall) {
  const double coarse = error_around_ball(0.3), fine = error_around_ball(0.1);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("fine", std::to_string(fine));
  EXPECT_LT(coarse, 0.5 * 0.3 / speed);
  EXPECT_LT(fine, 0.5 * 0.1 / speed);
  EXPECT_GT(std::log(coarse / fine) / std::log(3.0), 0.9) << coarse << " " << fine;
}

TEST(LightingAroundObstacles, TabulatedTimesBehindTheBall) {
  EXPECT_NEAR(time_around_ball({0.0, -5.0, 0.0}), 5.930503, 1e-6);
  EXPECT_NEAR(time_around_ball({0.0, -3.0, 0.0}), 5.321446, 1e-6);
  EXPECT_NEAR(time_around_ball({3.0, -3.0, 0.0}), 4.465252, 1e-6);
  EXPECT_NEAR(time_around_ball({4.0, 0.0, 0.0}), 3.201562, 1e-6);
}

/// Without an obstacle the times are straight ones.
TEST(LightingAroundObstacles, NothingInTheWay) {
  GridSpec grid;
  grid.mode = Mode::three_dimensional;
  grid.upper = {2.0, 3.0, 2.0};
  grid.cell_size = 0.125;
  auto of = detonation(
      {detonator(DetonatorKind::point, {0.0, 0.0, 0.0}),
       detonator(DetonatorKind::point, {2.0, 3.0, 1.0}, 0.25)},
      1.0
  );
  const LightingMap map(grid, {Box{grid.lower, grid.upper}}, of);
  double largest = 0.0;
  for (double x = 0.05; x < 2.0; x += 0.31)
    for (double y = 0.05; y < 3.0; y += 0.31)
      for (double z = 0.05; z < 2.0; z += 0.31)
        largest = std::max(
            largest,
            std::fabs(
                map.time_at({x, y, z}) -
                straight_lighting_time(of, Mode::three_dimensional, {x, y, z})
            )
        );
  EXPECT_LT(largest, 0.1 * grid.cell_size);
}

TEST(LightingAroundObstacles, APartThatIsCutOffStaysUnlit) {
  GridSpec grid;
  grid.mode = Mode::plane_strain;
  grid.upper = {4.0, 1.0, 0.0};
  grid.cell_size = 0.25;
  const Box left{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}}, right{{2.0, 0.0, 0.0}, {4.0, 1.0, 0.0}};
  const LightingMap map(
      grid, {left, right}, detonation({detonator(DetonatorKind::point, {0.5, 0.5, 0.0})}, 1.0)
  );
  EXPECT_FALSE(map.reaches_all());
  EXPECT_TRUE(std::isinf(map.time_at({3.0, 0.5, 0.0})));
  EXPECT_TRUE(std::isfinite(map.time_at({0.9, 0.9, 0.0})));
}

}  // namespace
}  // namespace barreno
