// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "geometry/disk.hpp"
#include "geometry/shape.hpp"
#include "geometry/slices.hpp"
#include "geometry/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

TEST(Disk, FillsRectanglesInClosedForm) {
  const DiskMoments all = disk_moments(2.0, {{-3.0, -3.0}, {3.0, 3.0}});
  EXPECT_NEAR(all.area, 4.0 * pi, 1e-14);
  EXPECT_NEAR(all.x, 0.0, 1e-14);
  // A quarter has its centroid at 4 R / (3 pi) along both axes, its first moment is R^3 / 3.
  const DiskMoments quarter = disk_moments(2.0, {{0.0, 0.0}, {5.0, 2.0}});
  EXPECT_NEAR(quarter.area, pi, 1e-14);
  EXPECT_NEAR(quarter.x, 8.0 / 3.0, 1e-14);
  EXPECT_NEAR(quarter.y, 8.0 / 3.0, 1e-14);
  // The segment beyond x = 1: R^2 acos(d/R) - d sqrt(R^2 - d^2), first moment 2/3 (R^2 - d^2)^1.5.
  const DiskMoments segment = disk_moments(2.0, {{1.0, -9.0}, {9.0, 9.0}});
  EXPECT_NEAR(segment.area, 4.0 * std::acos(0.5) - std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(segment.x, 2.0 / 3.0 * std::pow(3.0, 1.5), 1e-14);
  EXPECT_EQ(disk_moments(2.0, {{2.5, 0.0}, {3.0, 1.0}}).area, 0.0);
}

TEST(Slices, HoldABallAndItsCap) {
  const Vector centre{1.0, -2.0, 0.5};
  const Box around{{-1.0, -4.0, -1.5}, {3.0, 0.0, 2.5}};
  const Piece ball = slice_ball(centre, 1.5, around);
  EXPECT_NEAR(ball.measure, 4.0 / 3.0 * pi * 3.375, 1e-10);
  // Moments are about the centre. A cap of height h above z: pi h^2 (3 R - h) / 3, and half a
  // ball's moment is pi R^4 / 4.
  const Piece half = slice_ball(centre, 1.5, {{-1.0, -4.0, 0.5}, {3.0, 0.0, 2.5}});
  EXPECT_NEAR(half.measure, 2.0 / 3.0 * pi * 3.375, 1e-10);
  EXPECT_NEAR(half.centroid[2], 0.25 * pi * std::pow(1.5, 4), 1e-10);
  EXPECT_NEAR(half.centroid[0], 0.0, 1e-10);
  const Piece cap = slice_ball(centre, 1.5, {{-1.0, -4.0, 1.5}, {3.0, 0.0, 2.5}});
  EXPECT_NEAR(cap.measure, pi * 0.25 * 4.0 / 3.0, 1e-10);
}

TEST(Slices, HoldAFrustum) {
  const Round frustum{{0.0, 0.0, 0.0}, 1, 1.0, 4.0, 2.0, 1.0};
  const Piece piece = slice_round(frustum, {{-3.0, 0.0, -3.0}, {3.0, 5.0, 3.0}});
  EXPECT_NEAR(piece.measure, pi * 3.0 / 3.0 * (4.0 + 2.0 + 1.0), 1e-9);
  // In the first octant of its plane, a quarter of it.
  const Piece quarter = slice_round(frustum, {{0.0, 0.0, 0.0}, {3.0, 5.0, 3.0}});
  EXPECT_NEAR(quarter.measure, 0.25 * piece.measure, 1e-9);
  EXPECT_NEAR(quarter.centroid[0], quarter.centroid[2], 1e-9);
}

TEST(Slices, TellWhereABoxLiesInABall) {
  Ball ball;
  ball.radius = 2.0;
  EXPECT_EQ(side_of(ball, {{-1, -1, -1}, {1, 1, 1}}, 3), Side::inside);
  EXPECT_EQ(side_of(ball, {{-1, -1, -1}, {1, 1, 3}}, 3), Side::cut);
  EXPECT_EQ(side_of(ball, {{1.5, 1.5, 0}, {3, 3, 1}}, 3), Side::outside);
  EXPECT_EQ(side_of(ball, {{1, 1, 7}, {1.2, 1.2, 9}}, 2), Side::inside);  // z is not looked at
}

TEST(Shape, IsPlainDataOfOneKind) {
  Combination both;
  both.operation = Operation::subtract;
  both.parts = {Shape(Box{{0, 0, 0}, {1, 1, 1}}), Shape(Ball{})};
  const Shape shape = both;
  ASSERT_TRUE(std::holds_alternative<Combination>(shape));
  EXPECT_TRUE(std::holds_alternative<Ball>(std::get<Combination>(shape).parts[1]));
}

/// Corners at the origin and at 1, 2, 3 along the axes; volume 1.
Surface tetrahedron() {
  return {
      {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(Surface, OfATetrahedronIsSoundAndFillsIt) {
  const Surface surface = tetrahedron();
  EXPECT_NEAR(surface.volume(), 1.0, 1e-15);
  EXPECT_EQ(surface.around().upper, (Vector{1, 2, 3}));
  EXPECT_EQ(surface.winding({0.1, 0.2, 0.3}), 1);
  EXPECT_EQ(surface.winding({0.9, 1.8, 0.3}), 0);
  EXPECT_FALSE(surface.comes_near({{2, 2, 2}, {3, 3, 3}}));
  const Piece whole = surface.piece_in({{-1, -1, -1}, {4, 4, 4}});
  EXPECT_NEAR(whole.measure, 1.0, 1e-14);
  EXPECT_NEAR(whole.centroid[2], 0.75, 1e-14);
  // Above z = 1.5, half of its height, an eighth is left.
  EXPECT_NEAR(surface.piece_in({{-1, -1, 1.5}, {4, 4, 4}}).measure, 0.125, 1e-14);
  const SurfaceFaults faults = faults_of(surface);
  EXPECT_EQ(faults.open_edges + faults.branching_edges, 0);
  EXPECT_EQ(faults.flipped_facets + faults.wrong_facets, 0);
}

TEST(Surface, WithAHoleOrAFlippedFacetIsFaulty) {
  const Surface sound = tetrahedron();
  std::vector<Surface::Facet> facets = sound.facets();
  std::swap(facets[3][0], facets[3][1]);
  EXPECT_GT(faults_of({sound.points(), facets}).flipped_facets, 0);
  facets.pop_back();
  EXPECT_EQ(faults_of({sound.points(), facets}).open_edges, 3);
}

}  // namespace
}  // namespace barreno
