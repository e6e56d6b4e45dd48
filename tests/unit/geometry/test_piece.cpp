// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "geometry/piece.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace barreno {
namespace {

/// Counted on a fine raster of points, each asked by itself.
Piece counted(const Shape& shape, const Box& box, int dimension) {
  const int n = dimension == 2 ? 300 : 60;
  const auto d = static_cast<std::size_t>(dimension);
  const double share = measure_of(box, dimension) / std::pow(n, dimension);
  Piece sum;
  for (int k = 0; k < (dimension == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const std::array<int, 3> index{i, j, k};
        Vector x{};
        for (std::size_t c = 0; c < d; ++c)
          x[c] = box.lower[c] + (index[c] + 0.5) / n * (box.upper[c] - box.lower[c]);
        if (!holds(shape, x, dimension)) continue;
        sum.measure += share;
        for (std::size_t c = 0; c < d; ++c) sum.centroid[c] += share * x[c];
      }
  if (sum.measure > 0.0)
    for (double& x : sum.centroid) x /= sum.measure;
  return sum;
}

const Polygon notched{{{-1.6, -1.4}, {1.5, -1.2}, {1.7, 1.3}, {0.2, -0.3}, {-1.4, 1.1}}};

Polygon extruded(int axis) {
  Polygon polygon = notched;
  polygon.axis = axis;
  polygon.from = -0.9;
  polygon.to = 1.1;
  return polygon;
}

HalfSpace half_space(double x, double y, double z) {
  const double length = std::hypot(x, y, z);
  return {{0.2, -0.1, 0.3}, {x / length, y / length, z / length}};
}

std::vector<Shape> shapes_2d() {
  const Ball ball{{0.3, -0.2, 0.0}, 1.5, 0.7};
  const Box box{{-1.2, -0.4, 0.0}, {0.9, 1.1, 0.0}};
  return {
      ball,
      box,
      notched,
      half_space(0.6, -0.8, 0.0),
      half_space(1e-6, 1.0, 0.0),
      Combination{Operation::unite, {ball, notched}},
      Combination{Operation::subtract, {box, ball, half_space(1.0, 0.3, 0.0)}},
      Combination{Operation::intersect, {ball, box, notched}}};
}

std::vector<Shape> shapes_3d() {
  const Ball ball{{0.3, -0.2, 0.1}, 1.5, 0.7};
  const Box box{{-1.2, -0.4, -1.0}, {0.9, 1.1, 0.8}};
  const Cone tube{{0.1, -0.2, -1.3}, {0.1, -0.2, 1.2}, 1.4, 1.4, 0.6};
  const Cone oblique{{-0.9, -0.7, -0.8}, {0.8, 0.9, 1.1}, 1.2, 0.3, 0.0};
  return {
      ball,
      box,
      tube,
      Cone{{-1.5, 0.1, 0.2}, {1.6, 0.1, 0.2}, 1.3, 0.0, 0.0},
      Cone{{0.2, 1.5, 0.2}, {0.2, -1.3, 0.2}, 0.4, 1.2, 0.0},
      oblique,
      extruded(0),
      extruded(1),
      extruded(2),
      half_space(0.5, -0.7, 0.4),
      half_space(0.5, 0.0, 0.4),
      Combination{Operation::unite, {ball, extruded(2)}},
      Combination{Operation::subtract, {ball, tube, box}},
      Combination{Operation::intersect, {ball, box, oblique}}};
}

/// Random boxes, most of them cut, against the count.
void compare(const std::vector<Shape>& shapes, int dimension, double tolerance) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-2.0, 1.0), edge(0.3, 2.0);
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    int cut = 0;
    for (int k = 0; k < 16; ++k) {
      Box box;
      for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
        box.lower[i] = place(random);
        box.upper[i] = box.lower[i] + edge(random);
      }
      const Piece exact = piece_of(shapes[s], box, dimension);
      const Piece count = counted(shapes[s], box, dimension);
      const double all = measure_of(box, dimension);
      EXPECT_NEAR(exact.measure, count.measure, tolerance * all) << "shape " << s;
      if (side_of(shapes[s], box, dimension) == Side::inside) {
        // The count is a sum of up to millions of equal parts: 5e-12 of round-off.
        EXPECT_NEAR(count.measure, all, 1e-11 * all) << "shape " << s;
      }
      if (count.measure < 0.05 * all || count.measure > 0.99 * all) continue;
      ++cut;
      for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
        EXPECT_NEAR(exact.centroid[i], count.centroid[i], 4.0 * tolerance) << "shape " << s;
    }
    EXPECT_GT(cut, 2) << "shape " << s;
  }
}

TEST(PieceOf, IsWhatACountOfPointsFindsInThePlane) {
  compare(shapes_2d(), 2, 4e-3);
}

TEST(PieceOf, IsWhatACountOfPointsFindsInSpace) {
  compare(shapes_3d(), 3, 8e-3);
}

/// The volume of the whole from pieces in a raster that fits nothing.
double sum_of_pieces(const Shape& shape, int dimension, int n) {
  double sum = 0.0;
  const double size = 4.2 / n;
  for (int k = 0; k < (dimension == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vector lower{-2.11 + i * size, -2.07 + j * size, -2.13 + k * size};
        const Box box{lower, {lower[0] + size, lower[1] + size, lower[2] + size}};
        sum += piece_of(shape, box, dimension).measure;
      }
  return sum;
}

TEST(PieceOf, AddsUpToTheExactMeasure) {
  for (const Shape& shape : shapes_2d()) {
    if (std::holds_alternative<HalfSpace>(shape) || std::holds_alternative<Combination>(shape))
      continue;
    EXPECT_NEAR(sum_of_pieces(shape, 2, 17) / measure_bound(shape, 2), 1.0, 1e-12);
  }
  const std::vector<Shape> shapes = shapes_3d();
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const Shape& shape = shapes[s];
    if (std::holds_alternative<HalfSpace>(shape) || std::holds_alternative<Combination>(shape))
      continue;
    // The sixth points in no direction of the coordinates.
    const double error = std::abs(sum_of_pieces(shape, 3, 13) / measure_bound(shape, 3) - 1.0);
    EXPECT_LT(error, s == 5 ? 5e-4 : 1e-9) << "shape " << s;
  }
}

TEST(PieceOf, ExactVolumesAreThoseOfTheFormulas) {
  EXPECT_NEAR(measure_bound(Ball{{}, 2.0, 1.0}, 3), 4.0 / 3.0 * pi * 7.0, 1e-12);
  EXPECT_NEAR(measure_bound(Cone{{}, {0.0, 0.0, 3.0}, 2.0, 0.0}, 3), 4.0 * pi, 1e-12);
  EXPECT_NEAR(measure_bound(Cone{{}, {3.0, 4.0, 0.0}, 2.0, 2.0, 1.0}, 3), 15.0 * pi, 1e-12);
  EXPECT_NEAR(measure_bound(Polygon{{{0, 0}, {0, 2}, {1, 1}, {2, 2}, {2, 0}}}, 2), 3.0, 1e-15);
}

TEST(PieceOf, BoxesInCombinationAreExact) {
  const Box block{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, hole{{-0.3, -0.2, -1.0}, {0.45, 0.33, 1.0}};
  const Box lid{{-1.0, -1.0, 1.0}, {1.0, 1.0, 1.7}};
  const Shape drilled = Combination{Operation::subtract, {block, hole}};
  const Shape closed = Combination{Operation::unite, {drilled, lid}};
  EXPECT_NEAR(sum_of_pieces(drilled, 3, 13), 8.0 - 2.0 * 0.75 * 0.53, 1e-12);
  EXPECT_NEAR(sum_of_pieces(closed, 3, 13), 8.0 - 2.0 * 0.75 * 0.53 + 4.0 * 0.7, 1e-12);
  EXPECT_NEAR(sum_of_pieces(drilled, 2, 13), 4.0 - 0.75 * 0.53, 1e-13);
}

/// A hollow cone: two surfaces end in one plane, which cuts boxes or lies on their faces.
TEST(PieceOf, ConesThatEndInOnePlaneAreExactTogether) {
  const Cone outer{{0.0, -1.5, 0.0}, {0.0, 1.3, 0.0}, 0.0, 2.0};
  const Cone inner{{0.0, -0.5, 0.0}, {0.0, 1.3, 0.0}, 0.0, 1.1};
  const Shape hollow = Combination{Operation::subtract, {outer, inner}};
  const double exact = pi / 3.0 * (2.0 * 2.0 * 2.8 - 1.1 * 1.1 * 1.8);
  EXPECT_NEAR(sum_of_pieces(hollow, 3, 13), exact, 1e-9);
}

TEST(SideOf, AFaceOnTheEndOfAConeIsNotCutWhateverTheRoundOff) {
  const Cone cone{{0.0, 0.0, 0.0}, {0.0, 1.3, 0.0}, 2.0, 1.0};
  for (const double end : {std::nextafter(1.3, 0.0), 1.3, std::nextafter(1.3, 2.0)}) {
    EXPECT_EQ(side_of(cone, {{0.0, 1.0, 0.0}, {0.3, end, 0.3}}, 3), Side::inside);
    EXPECT_EQ(side_of(cone, {{0.0, end, 0.0}, {0.3, 1.6, 0.3}}, 3), Side::outside);
  }
  EXPECT_EQ(side_of(cone, {{0.0, 1.2, 0.0}, {0.3, 1.4, 0.3}}, 3), Side::cut);
  // Beside the surface, where a ball around the box would meet it.
  EXPECT_EQ(side_of(cone, {{1.1, 1.2, -0.5}, {1.5, 1.29, 0.5}}, 3), Side::outside);
  EXPECT_EQ(side_of(cone, {{0.5, 1.2, -0.5}, {0.8, 1.29, 0.5}}, 3), Side::inside);
}

TEST(PieceOf, NeighboursShareNoPointAndLeaveNone) {
  const Polygon left{{{-1.0, -1.0}, {0.3, -1.0}, {-0.2, 1.0}, {-1.0, 1.0}}};
  const Polygon right{{{0.3, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-0.2, 1.0}}};
  for (int i = 0; i < 400; ++i) {
    const double y = -1.0 + 2.0 * i / 400.0;
    const Vector x{0.3 - 0.25 * (y + 1.0), y, 0.0};
    EXPECT_NE(holds(left, x, 2), holds(right, x, 2)) << y;
  }
}

TEST(PieceOfBall, OfABoxAroundIsTheWholeAndOfOneBesideIsNothing) {
  const Ball ball{{1.0, 2.0, 0.0}, 0.5, 0.2};
  const Piece whole = piece_of(ball, {{0.0, 0.0, 0.0}, {3.0, 3.0, 0.0}}, 2);
  EXPECT_NEAR(whole.measure, pi * (0.25 - 0.04), 1e-14);
  EXPECT_NEAR(whole.centroid[0], 1.0, 1e-14);
  EXPECT_NEAR(whole.centroid[1], 2.0, 1e-14);
  EXPECT_EQ(piece_of(ball, {{2.0, 2.0, 0.0}, {3.0, 3.0, 0.0}}, 2).measure, 0.0);
  EXPECT_EQ(piece_of(ball, {{0.95, 1.95, 0.0}, {1.05, 2.05, 0.0}}, 2).measure, 0.0);
}

}  // namespace
}  // namespace barreno
