// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "base/work_counts.hpp"
#include "geometry/fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace barreno {
namespace {

/// Off the lattice, so that nothing fits by chance.
constexpr Vector origin{-2.013, -2.007, -2.019};

double filled(const Shape& shape, int dimension, double size) {
  const Lattice lattice = lattice_around(box_around(shape), origin, size, dimension);
  double sum = 0.0;
  for_each_lattice_piece(shape, dimension, lattice, [&](const auto& /*cell*/, const Piece& piece) {
    sum += piece.measure;
  });
  return sum;
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

/// A curved wall whose thickness grows along it, by points on its two faces.
Polygon curved_wall(int pieces) {
  Polygon wall;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 0.5 * pi * i / pieces;
    wall.corners.push_back({1.5 * std::cos(angle), 1.5 * std::sin(angle)});
  }
  for (int i = pieces; i >= 0; --i) {
    const double angle = 0.5 * pi * i / pieces, radius = 1.4 - 0.2 * i / pieces;
    wall.corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return wall;
}

TEST(Fill, ACurvedWallOfPointsConvergesToItsArea) {
  // Half the integral of 1.5^2 - (1.4 - 0.2 s)^2 over the quarter circle, s from 0 to 1.
  const double inner = (std::pow(1.4, 3) - std::pow(1.2, 3)) / 0.6;
  const double exact = 0.25 * pi * (2.25 - inner);
  const double coarse = filled(curved_wall(16), 2, 0.05) / exact - 1.0;
  const double fine = filled(curved_wall(32), 2, 0.05) / exact - 1.0;
  EXPECT_LT(std::abs(fine), 1e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.2);
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

using CellIndex = std::array<long long, 3>;
using PieceOfCell = std::map<CellIndex, Piece>;

/// Piece by piece over a whole lattice, as the rule of slivers is told in fill.hpp.
PieceOfCell joined_pieces(const Shape& shape, int dimension, const Lattice& lattice) {
  PieceOfCell pieces;
  CellIndex c{};
  for (c[2] = 0; c[2] < lattice.count[2]; ++c[2])
    for (c[1] = 0; c[1] < lattice.count[1]; ++c[1])
      for (c[0] = 0; c[0] < lattice.count[0]; ++c[0]) {
        Box box;
        for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
          box.lower[i] = lattice.lower[i] + static_cast<double>(c[i]) * lattice.size;
          box.upper[i] = box.lower[i] + lattice.size;
        }
        const Piece piece = piece_of(shape, box, dimension);
        if (piece.measure > 0.0) pieces[c] = piece;
      }
  const double cell = std::pow(lattice.size, dimension);
  const auto measure = [&](const CellIndex& at) {
    const auto found = pieces.find(at);
    return found == pieces.end() ? 0.0 : found->second.measure;
  };
  PieceOfCell sums = pieces;
  std::vector<std::pair<CellIndex, CellIndex>> moves;  // from, to; in the order of a walk
  for (c[2] = 0; c[2] < lattice.count[2]; ++c[2])
    for (c[1] = 0; c[1] < lattice.count[1]; ++c[1])
      for (c[0] = 0; c[0] < lattice.count[0]; ++c[0]) {
        CellIndex to = c;
        for (CellIndex from = c; measure(c) > 0.0 && measure(to) < 0.25 * cell; from = to) {
          for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
            for (const long long step : {-1LL, 1LL}) {
              CellIndex next = from;
              next[i] += step;
              if (measure(next) > measure(to) + 1e-9 * cell) to = next;
            }
          if (to == from) break;
        }
        if (to != c) moves.emplace_back(c, to);
      }
  for (const auto& [from, to] : moves) sums.erase(from);
  for (const auto& [from, to] : moves) add(sums.at(to), pieces.at(from));
  return sums;
}

/// Shapes with slivers of all sorts, some of which go on from one to the next.
std::vector<std::pair<Shape, int>> shapes_with_slivers() {
  const Polygon needle{{{-1.0, -0.97}, {1.0, -1.0}, {1.1, -0.8}}};
  return {
      {Ball{{0.1, -0.2, 0.05}, 1.1, 0.6}, 3},
      {Ball{{0.1, -0.2, 0.0}, 1.1, 0.0}, 2},
      {Cone{{-0.9, -0.7, -0.8}, {0.8, 0.9, 1.1}, 0.8, 0.1}, 3},
      {needle, 2},
      {Combination{Operation::unite, {needle, Ball{{0.4, 0.3, 0.0}, 0.5, 0.42}}}, 2}};
}

/// Found in so many spans, one after the other.
PieceOfCell pieces_of_spans(const Shape& shape, int dimension, const Lattice& lattice, int ranks) {
  PieceOfCell found;
  long long begin = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    const CellSpan span = share_of_cells(lattice, rank, ranks);
    EXPECT_EQ(span.begin, begin);
    begin = span.end;
    const auto take = [&](const CellIndex& cell, const Piece& piece) {
      EXPECT_TRUE(found.emplace(cell, piece).second);
    };
    for_each_lattice_piece(shape, dimension, lattice, span, take);
  }
  EXPECT_EQ(begin, count_cells(lattice));
  return found;
}

TEST(Fill, PiecesOfSpansAreThoseOfTheWholeToTheBit) {
  for (const auto& [shape, dimension] : shapes_with_slivers()) {
    const Lattice lattice = lattice_around(box_around(shape), origin, 0.1, dimension);
    const PieceOfCell whole = joined_pieces(shape, dimension, lattice);
    for (const int ranks : {1, 2, 3, 7, 50}) {
      PieceOfCell found = pieces_of_spans(shape, dimension, lattice, ranks);
      ASSERT_EQ(found.size(), whole.size());
      for (const auto& [cell, piece] : whole) {
        ASSERT_EQ(found.count(cell), 1U);
        EXPECT_EQ(found[cell].measure, piece.measure);
        EXPECT_EQ(found[cell].centroid, piece.centroid);
      }
    }
  }
}

TEST(Fill, ASpanLooksAtLittleOutsideOfItself) {
  const Shape ball = Ball{{0.1, -0.2, 0.05}, 1.1};
  const Lattice lattice = lattice_around(box_around(ball), origin, 0.04, 3);
  const auto looked_at = [&](int rank, int ranks) {
    const long long before = work_counts().candidate_points;
    for_each_lattice_piece(
        ball, 3, lattice, share_of_cells(lattice, rank, ranks), [](const auto&, const Piece&) {}
    );
    return static_cast<double>(work_counts().candidate_points - before);
  };
  const double all = looked_at(0, 1);
  EXPECT_LT(all, 1.5 * static_cast<double>(count_cells(lattice)));
  for (const int ranks : {2, 4, 8})
    for (int rank = 0; rank < ranks; ++rank) EXPECT_LT(looked_at(rank, ranks), 1.5 * all / ranks);
}

TEST(Fill, TheFullestCellIsFoundAtTheSurface) {
  const Shape ball = Ball{{0.1, -0.2, 0.05}, 1.1};
  const Lattice lattice = lattice_around(box_around(ball), origin, 0.02, 3);
  const long long before = work_counts().undivided_points;
  EXPECT_GE(fullest_cell(ball, 3, lattice, 0.5), 0.5);
  EXPECT_LT(work_counts().undivided_points - before, count_cells(lattice) / 1000);
  // Nowhere wider than a third of a cell: every cell of its surface is looked at.
  const Shape wall = Box{{-1.0, -1.0, 0.001}, {1.0, 1.0, 0.007}};
  double fullest = 0.0;
  for (const auto& [cell, piece] : joined_pieces(wall, 3, lattice))
    fullest = std::max(fullest, piece.measure / std::pow(lattice.size, 3));
  EXPECT_NEAR(fullest_cell(wall, 3, lattice, 0.5), 0.3, 1e-9);
  EXPECT_GE(fullest, 0.3 - 1e-9);
  EXPECT_EQ(fullest_cell(Ball{{9.0, 9.0, 9.0}, 0.5}, 3, lattice, 0.5), 0.0);
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
