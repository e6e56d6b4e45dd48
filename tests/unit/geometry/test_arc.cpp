// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "geometry/arc.hpp"
#include "geometry/drawn_polygon.hpp"
#include "geometry/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace barreno {
namespace {

using Point = std::array<double, 2>;
using Rows = std::vector<std::vector<double>>;

Point at(double radius, double degrees) {
  const double angle = degrees * pi / 180.0;
  return {0.3 + radius * std::cos(angle), -0.2 + radius * std::sin(angle)};
}

std::vector<double> row_of(const Point& p) {
  return {p[0], p[1]};
}
std::vector<double> arc_of(double edge, const Point& p) {
  return {edge, p[0], p[1]};
}

DrawnPolygon drawn(const Rows& corners, const Rows& arcs) {
  std::string problem;
  DrawnPolygon polygon = draw_polygon(corners, arcs, problem);
  EXPECT_EQ(problem, "");
  return polygon;
}

std::string problem_of(const Rows& corners, const Rows& arcs) {
  std::string problem;
  draw_polygon(corners, arcs, problem);
  return problem;
}

/// Area and mean first coordinate of a figure, from pieces of cells.
Piece filled(const DrawnPolygon& figure, double size) {
  Polygon polygon;
  polygon.corners = figure.corners;
  Piece sum;
  const Lattice lattice = lattice_around(box_around(Shape(polygon)), {-3.0, -3.0, 0.0}, size, 2);
  for_each_lattice_piece(Shape(polygon), 2, lattice, [&](const auto& /*cell*/, const Piece& piece) {
    add(sum, piece);
  });
  return sum;
}

TEST(Arc, ChordsStayWithinTheirToleranceOfTheCircle) {
  for (const double sweep : {0.5, 8.0, 60.0, 179.0, 180.0, 300.0, 355.0}) {
    const Point a = at(1.7, 20.0), through = at(1.7, 20.0 + 0.3 * sweep), b = at(1.7, 20.0 + sweep);
    std::vector<Point> all{a};
    for (const Point& corner : corners_of_arc(a, through, b)) all.push_back(corner);
    all.push_back(b);
    const double chords = static_cast<double>(all.size()) - 1.0;
    EXPECT_EQ(chords, std::max(8.0, std::ceil(sweep - 1e-6))) << sweep;
    double furthest = 0.0;
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
      for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double x = all[i][0] + s * (all[i + 1][0] - all[i][0]) - 0.3;
        const double y = all[i][1] + s * (all[i + 1][1] - all[i][1]) + 0.2;
        furthest = std::max(furthest, std::abs(std::hypot(x, y) / 1.7 - 1.0));
      }
    EXPECT_LE(furthest, chord_tolerance) << sweep;
  }
}

TEST(Arc, GoesThroughItsPointOnEitherSide) {
  // Three quarters of the circle, or the fourth, between the same ends.
  const Rows ends{row_of(at(1.0, 0.0)), row_of(at(1.0, 90.0))};
  const double segment = 0.25 * pi - 0.5;
  EXPECT_NEAR(filled(drawn(ends, {arc_of(1.0, at(1.0, 40.0))}), 0.1).measure, segment, 1e-12);
  EXPECT_NEAR(filled(drawn(ends, {arc_of(1.0, at(1.0, 200.0))}), 0.1).measure, pi - segment, 1e-12);
}

TEST(Arc, BothSidesHaveTheSameCorners) {
  const Point a = at(1.3, 250.0), through = at(1.3, 300.0), b = at(1.3, 371.0);
  std::vector<Point> forth = corners_of_arc(a, through, b), back = corners_of_arc(b, through, a);
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(forth, back);
}

TEST(Arc, OnALineThereIsNone) {
  EXPECT_TRUE(corners_of_arc({0.0, 0.0}, {1.0, 2.0}, {2.0, 4.0}).empty());
  EXPECT_TRUE(corners_of_arc({0.0, 0.0}, {1.0, 2.0 + 1e-8}, {2.0, 4.0}).empty());
  EXPECT_TRUE(corners_of_arc({0.0, 0.0}, {0.0, 0.0}, {2.0, 4.0}).empty());
  EXPECT_FALSE(corners_of_arc({0.0, 0.0}, {1.0, 2.1}, {2.0, 4.0}).empty());
}

/// The wall of a hemisphere in {r, axial}: outer and inner face are quarter circles.
DrawnPolygon hemisphere(double outer, double inner) {
  const double s = std::sqrt(0.5);
  return drawn(
      {{outer, 0.0}, {0.0, outer}, {0.0, inner}, {inner, 0.0}},
      {{1.0, outer * s, outer * s}, {3.0, inner * s, inner * s}}
  );
}

TEST(Arc, TheWallOfAHemisphereHasItsAreaAndVolume) {
  for (const double inner : {1.2, 1.4}) {
    const Piece wall = filled(hemisphere(1.5, inner), 0.05);
    EXPECT_NEAR(wall.measure, 0.25 * pi * (2.25 - inner * inner), 1e-12);
    // Turned about the axis (Pappus and Guldin).
    const double volume = two_pi * wall.measure * wall.centroid[0];
    const double exact = two_pi / 3.0 * (std::pow(1.5, 3) - std::pow(inner, 3));
    EXPECT_NEAR(volume / exact, 1.0, 1e-6);
  }
}

TEST(DrawnPolygon, TellsWhichEdgeACornerIsOf) {
  const DrawnPolygon wall = hemisphere(1.5, 1.2);
  ASSERT_EQ(wall.corners.size(), 180U + 2U);
  EXPECT_EQ(std::count(wall.edges.begin(), wall.edges.end(), 1U), 90);
  EXPECT_EQ(std::count(wall.edges.begin(), wall.edges.end(), 3U), 90);
  EXPECT_TRUE(crossing_edges(wall).empty());
}

TEST(DrawnPolygon, AnArcThatCrossesAnEdgeIsFound) {
  const Rows flat{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.2}, {0.0, 0.2}};
  const DrawnPolygon bent = drawn(flat, {{1.0, 0.5, 0.3}});
  EXPECT_EQ(crossing_edges(bent), (std::vector<std::size_t>{1, 3}));
}

TEST(DrawnPolygon, WrongArcsAreToldBySentence) {
  const Rows square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  for (const double number : {0.0, 5.0, 1.5, -1.0, std::nan("")})
    EXPECT_EQ(
        problem_of(square, {{2.0, 1.2, 0.5}, {number, 0.5, 0.1}}),
        "has no edge for row 2 (edges are numbered from 1 to 4, each as the corner that it starts "
        "from); correct the number"
    );
  EXPECT_EQ(
      problem_of(square, {{2.0, 1.2, 0.5}, {2.0, 1.1, 0.5}}),
      "has two arcs for one edge in row 1 and row 2; remove one of them, or add a corner where "
      "they "
      "meet"
  );
  EXPECT_EQ(
      problem_of(square, {{4.0, 0.0, 0.5}}),
      "has a point in row 1 that lies on the line through the ends of its edge (no circle goes "
      "through the three); move it, or remove the row"
  );
}

}  // namespace
}  // namespace barreno
