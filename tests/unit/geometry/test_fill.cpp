// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "geometry/fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <set>

namespace barreno {
namespace {

/// Off the lattice, so that nothing fits by chance.
constexpr Vector origin{-2.013, -2.007, -2.019};

double filled(const Shape& shape, int dimension, double size) {
  return filling_of(shape, dimension, lattice_around(box_around(shape), origin, size, dimension))
      .measure;
}

/// Relative error of the filled volume at two sizes of particles.
void expect_volume(const char* name, const Shape& shape, double exact, double coarse, double fine) {
  const double at_coarse = std::abs(filled(shape, 3, 0.2) / exact - 1.0);
  const double at_fine = std::abs(filled(shape, 3, 0.1) / exact - 1.0);
  std::cout << name << ": relative error of the volume " << at_coarse << " at 0.2, " << at_fine
            << " at 0.1\n";
  EXPECT_LT(at_coarse, coarse) << name;
  EXPECT_LT(at_fine, fine) << name;
}

TEST(Fill, VolumesAlongTheCoordinatesAreExact) {
  expect_volume(
      "ball", Ball{{0.1, 0.0, 0.0}, 1.3, 0.0}, 4.0 / 3.0 * pi * std::pow(1.3, 3), 1e-10, 1e-10
  );
  expect_volume(
      "shell",
      Ball{{}, 1.3, 0.8},
      4.0 / 3.0 * pi * (std::pow(1.3, 3) - std::pow(0.8, 3)),
      1e-10,
      1e-10
  );
  expect_volume(
      "cone", Cone{{0.1, 0.1, -1.0}, {0.1, 0.1, 1.4}, 1.2, 0.0}, pi * 1.44 * 2.4 / 3.0, 1e-10, 1e-10
  );
  expect_volume(
      "cylinder", Cone{{-1.0, 0.1, 0.2}, {1.2, 0.1, 0.2}, 1.1, 1.1}, pi * 1.21 * 2.2, 1e-10, 1e-10
  );
  Polygon notch{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {0.1, -0.4}, {-1.0, 1.0}}};
  notch.from = -0.7;
  notch.to = 0.9;
  expect_volume("notched bar", notch, 1.6 * (4.0 - 0.5 * 2.0 * 1.4), 1e-12, 1e-12);
}

TEST(Fill, ObliqueAndCombinedVolumesConverge) {
  expect_volume(
      "oblique cylinder",
      Cone{{-0.9, -0.7, -0.8}, {0.8, 0.9, 1.1}, 0.8, 0.8},
      pi * 0.64 * std::sqrt(1.7 * 1.7 + 1.6 * 1.6 + 1.9 * 1.9),
      2e-4,
      5e-5
  );
  expect_volume(
      "oblique cone",
      Cone{{-0.9, -0.7, -0.8}, {0.8, 0.9, 1.1}, 1.0, 0.4},
      pi * (1.0 + 0.4 + 0.16) / 3.0 * std::sqrt(1.7 * 1.7 + 1.6 * 1.6 + 1.9 * 1.9),
      2e-4,
      5e-5
  );
  // A ball of radius R with a bore keeps pi h^3 / 6, h its remaining height.
  const Cone bore{{0.1, 0.0, -2.0}, {0.1, 0.0, 2.0}, 0.5, 0.5};
  const double height = 2.0 * std::sqrt(1.3 * 1.3 - 0.25);
  expect_volume(
      "drilled ball",
      Combination{Operation::subtract, {Ball{{0.1, 0.0, 0.0}, 1.3}, bore}},
      pi * std::pow(height, 3) / 6.0,
      1e-4,
      3e-5
  );
  const double cap = 0.8;
  expect_volume(
      "lens of two balls",
      Combination{Operation::intersect, {Ball{{-0.5, 0.0, 0.0}, 1.3}, Ball{{0.5, 0.0, 0.0}, 1.3}}},
      2.0 * pi * cap * cap * (3.0 * 1.3 - cap) / 3.0,
      1e-4,
      3e-5
  );
  const HalfSpace below{{0.0, 0.0, 0.3}, {0.36, 0.48, 0.8}};
  const double depth = 1.3 - 0.24;  // of the cap above the plane, at distance 0.24 from the centre
  expect_volume(
      "ball below a plane",
      Combination{Operation::intersect, {Ball{{}, 1.3}, below}},
      4.0 / 3.0 * pi * std::pow(1.3, 3) - pi * depth * depth * (3.0 * 1.3 - depth) / 3.0,
      1e-4,
      3e-5
  );
}

TEST(Fill, FiguresInThePlane) {
  const Polygon notch{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {0.1, -0.4}, {-1.0, 1.0}}};
  EXPECT_NEAR(filled(notch, 2, 0.13), 4.0 - 1.4, 1e-12);
  const double area =
      filled(Combination{Operation::subtract, {notch, Ball{{0.1, -0.9}, 0.35}}}, 2, 0.13);
  const double segment = 0.35 * 0.35 * std::acos(0.1 / 0.35) - 0.1 * std::sqrt(0.35 * 0.35 - 0.01);
  EXPECT_NEAR(area, 2.6 - (pi * 0.35 * 0.35 - segment), 2e-6);
}

TEST(Fill, KeepsFirstMomentsAndJoinsSlivers) {
  const Shape ball = Ball{{0.1, -0.2, 0.05}, 1.1};
  const Lattice lattice = lattice_around(box_around(ball), origin, 0.17, 3);
  Vector moment{};
  double volume = 0.0, least = 1.0;
  std::set<std::array<long long, 3>> cells;
  for_each_lattice_piece(ball, 3, lattice, [&](const auto& cell, const Piece& piece) {
    EXPECT_TRUE(cells.insert(cell).second);
    volume += piece.measure;
    least = std::min(least, piece.measure / std::pow(0.17, 3));
    for (std::size_t i = 0; i < 3; ++i) moment[i] += piece.measure * piece.centroid[i];
  });
  EXPECT_NEAR(moment[0] / volume, 0.1, 1e-10);
  EXPECT_NEAR(moment[1] / volume, -0.2, 1e-10);
  EXPECT_NEAR(moment[2] / volume, 0.05, 1e-10);
  EXPECT_GE(least, 0.24);
}

TEST(Fill, SharedPointsAreFoundAndTouchingIsNone) {
  const Polygon wedge{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}};
  const Polygon other{{{0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
  const Lattice lattice = lattice_around({{}, {1.0, 1.0, 0.0}}, {}, 0.05, 2);
  EXPECT_FALSE(have_common_points(wedge, other, 2, lattice));
  EXPECT_TRUE(have_common_points(wedge, Ball{{0.3, 0.4}, 0.15}, 2, lattice));
  EXPECT_FALSE(have_common_points(wedge, Ball{{0.3, 0.6}, 0.15}, 2, lattice));
}

/// A disk whose centre is a corner of the lattice is its own mirror image, and so are its
/// particles: also where a sliver on the diagonal could join either of two neighbours, and where
/// the circle touches a line of the lattice.
TEST(Fill, ParticlesOfADiskMirrorEachOther) {
  const Vector corner{0.0, 0.0, 0.0};
  const Ball disk{{0.3, 0.3, 0.0}, 0.2, 0.0};
  const Lattice lattice = lattice_around(box_around(disk), corner, 0.0125, 2);
  std::map<std::array<long long, 3>, Piece> pieces;
  for_each_lattice_piece(
      disk,
      2,
      lattice,
      [&](const std::array<long long, 3>& cell, const Piece& p) { pieces[cell] = p; }
  );
  ASSERT_EQ(lattice.count[0], lattice.count[1]);
  for (const auto& [cell, piece] : pieces)
    for (const std::size_t axis : {0U, 1U}) {
      std::array<long long, 3> other = cell;
      other[axis] = lattice.count[axis] - 1 - cell[axis];
      const auto found = pieces.find(other);
      ASSERT_NE(found, pieces.end());
      EXPECT_NEAR(found->second.measure, piece.measure, 1e-13 * 0.0125);
      for (const std::size_t i : {0U, 1U}) {
        const double mirrored = i == axis ? 0.6 - piece.centroid[i] : piece.centroid[i];
        EXPECT_NEAR(found->second.centroid[i], mirrored, 1e-9 * 0.0125);
      }
    }
}

}  // namespace
}  // namespace barreno
