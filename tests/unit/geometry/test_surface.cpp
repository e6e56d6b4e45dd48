// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "deck/files/read_surface.hpp"
#include "geometry/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <random>
#include <sstream>

namespace barreno {
namespace {

using Facet = std::array<Vector, 3>;
using Soup = std::vector<Facet>;

std::string as_text(const Soup& soup) {
  std::ostringstream out;
  out.precision(17);
  out << "solid test\n";
  for (const Facet& facet : soup) {
    out << "facet normal 0 0 0\n outer loop\n";
    for (const Vector& x : facet) out << "  vertex " << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
    out << " endloop\nendfacet\n";
  }
  out << "endsolid test\n";
  return out.str();
}

std::string as_binary(const Soup& soup) {
  std::string out(80, ' ');
  const auto put = [&](auto value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
  };
  put(static_cast<std::uint32_t>(soup.size()));
  for (const Facet& facet : soup) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (const Vector& x : facet)
      for (const double c : x) put(static_cast<float>(c));
    put(static_cast<std::uint16_t>(0));
  }
  return out;
}

Soup cube(double lower, double upper) {
  const auto corner = [&](unsigned k) {
    return Vector{
        (k & 1U) != 0U ? upper : lower,
        (k & 2U) != 0U ? upper : lower,
        (k & 4U) != 0U ? upper : lower};
  };
  Soup soup;
  for (const auto& q :
       {std::array<unsigned, 4>{0, 2, 3, 1},
        {4, 5, 7, 6},
        {0, 1, 5, 4},
        {2, 6, 7, 3},
        {0, 4, 6, 2},
        {1, 3, 7, 5}}) {
    soup.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
    soup.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
  }
  return soup;
}

/// An octahedron whose edges are halved and put on the sphere again and again.
Soup sphere(double radius, int halvings) {
  Soup soup;
  const auto on = [&](Vector x) {
    const double length = std::hypot(x[0], x[1], x[2]);
    for (double& c : x) c *= radius / length;
    return x;
  };
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0})
      for (const double c : {-1.0, 1.0}) {
        Facet facet{on({a, 0, 0}), on({0, b, 0}), on({0, 0, c})};
        if (a * b * c < 0.0) std::swap(facet[0], facet[1]);
        soup.push_back(facet);
      }
  for (int h = 0; h < halvings; ++h) {
    Soup finer;
    for (const Facet& f : soup) {
      const auto middle = [&](std::size_t i, std::size_t j) {
        return on({f[i][0] + f[j][0], f[i][1] + f[j][1], f[i][2] + f[j][2]});
      };
      const Vector a = middle(0, 1), b = middle(1, 2), c = middle(2, 0);
      for (const Facet& part : {Facet{f[0], a, c}, {a, f[1], b}, {c, b, f[2]}, {a, b, c}})
        finer.push_back(part);
    }
    soup = finer;
  }
  return soup;
}

Soup turned(Soup soup) {
  for (Facet& facet : soup) std::swap(facet[1], facet[2]);
  return soup;
}
Soup joined(Soup soup, const Soup& more) {
  soup.insert(soup.end(), more.begin(), more.end());
  return soup;
}
std::shared_ptr<const Surface> read(const std::string& text) {
  return read_surface(text, 1.0, {}, "part.stl");
}
std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "read";
}

double filled(const Shape& shape, const Lattice& lattice) {
  double sum = 0.0;
  for_each_lattice_piece(shape, 3, lattice, [&](const auto& /*cell*/, const Piece& piece) {
    sum += piece.measure;
  });
  return sum;
}

TEST(Surface, ACubeIsExactAsTextAndInBinary) {
  for (const std::string& text : {as_text(cube(-0.5, 0.75)), as_binary(cube(-0.5, 0.75))}) {
    const auto surface = read(text);
    EXPECT_EQ(surface->points().size(), 8U);
    EXPECT_DOUBLE_EQ(surface->volume(), std::pow(1.25, 3));
    for (const double size : {0.25, 0.31}) {
      const Shape shape = Faceted{surface};
      // At 0.25 all faces are those of the lattice.
      const Lattice lattice = lattice_around(surface->around(), {}, size, 3);
      EXPECT_NEAR(filled(shape, lattice), std::pow(1.25, 3), 1e-13);
    }
  }
}

TEST(Surface, UnitAndShiftMoveTheCorners) {
  const auto surface = read_surface(as_text(cube(0.0, 2.0)), 1e-3, {1.0, 2.0, 3.0}, "part.stl");
  EXPECT_DOUBLE_EQ(surface->around().lower[2], 3.0);
  EXPECT_DOUBLE_EQ(surface->around().upper[0], 1.002);
}

TEST(Surface, IsFilledExactlyAndConvergesToItsSphere) {
  double before = 1.0;
  for (const int halvings : {2, 3, 4, 5}) {
    const auto surface = read(as_text(sphere(1.3, halvings)));
    const Shape shape = Faceted{surface};
    const Lattice lattice = lattice_around(surface->around(), {-2.01, -2.02, -2.03}, 0.2, 3);
    const double volume = filled(shape, lattice);
    EXPECT_NEAR(volume / surface->volume(), 1.0, 1e-12);
    const double error = 1.0 - volume / (4.0 / 3.0 * pi * std::pow(1.3, 3));
    std::cout << "sphere of " << surface->facets().size() << " facets: volume " << error
              << " below the ball's\n";
    EXPECT_LT(error, 0.3 * before);
    before = error;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(Surface, PiecesAreWhatACountOfPointsFinds) {
  // A sphere with a hollow, and a part beside it.
  Soup other = cube(1.5, 1.9);
  const auto surface = read(as_text(joined(joined(sphere(1.3, 3), turned(sphere(0.7, 2))), other)));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.4, 1.0), edge(0.3, 1.0);
  for (int t = 0; t < 20; ++t) {
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
      box.lower[i] = place(random);
      box.upper[i] = box.lower[i] + edge(random);
    }
    constexpr int n = 40;
    Piece count;
    for (int k = 0; k < n * n * n; ++k) {
      const std::array<int, 3> index{k % n, k / n % n, k / n / n};
      Vector x{};
      for (std::size_t i = 0; i < 3; ++i)
        x[i] = box.lower[i] + (index[i] + 0.5) / n * (box.upper[i] - box.lower[i]);
      const double r = std::hypot(x[0], x[1], x[2]);
      const int winding = surface->winding(x);
      // Facets lie within 2 % below the radius.
      if (r < 1.27 && r > 0.7) {
        ASSERT_EQ(winding, 1);
      }
      if (r < 0.64 || (r > 1.3 && *std::min_element(x.begin(), x.end()) < 1.5)) {
        ASSERT_EQ(winding, 0);
      }
      if (winding != 0) add(count, {1.0, x});
    }
    const Piece piece = surface->piece_in(box);
    const double all = measure_of(box, 3);
    EXPECT_NEAR(piece.measure, count.measure * all / (n * n * n), 5e-3 * all);
    if (count.measure < 0.05 * n * n * n) continue;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(piece.centroid[i], count.centroid[i], 1e-2);
  }
}

TEST(Surface, LinesThroughCornersAndEdgesCountOnce) {
  const auto surface = read(as_text(sphere(1.0, 3)));
  for (const Vector& corner : surface->points()) {
    EXPECT_EQ(surface->winding({0.9 * corner[0], 0.9 * corner[1], 0.9 * corner[2]}), 1);
    EXPECT_EQ(surface->winding({corner[0], corner[1], -1.1}), 0);
    EXPECT_EQ(surface->winding({corner[0], corner[1], 1.1}), 0);
  }
}

TEST(Surface, FaultsAreNamedAndCounted) {
  Soup holed = cube(0.0, 1.0);
  holed.pop_back();
  EXPECT_EQ(
      refusal(as_text(holed)),
      "part.stl has 3 open edges (a solid needs a closed surface); close its holes where it was "
      "made."
  );
  Soup flipped = sphere(1.0, 2);
  std::swap(flipped[7][0], flipped[7][1]);
  std::swap(flipped[90][0], flipped[90][1]);
  EXPECT_NE(refusal(as_text(flipped)).find("has 2 flipped facets ("), std::string::npos);
  EXPECT_NE(
      refusal(as_text(turned(cube(0.0, 1.0)))).find("has 12 facets without"), std::string::npos
  );
  const Soup through = joined(sphere(1.0, 2), cube(0.0, 2.0));
  EXPECT_NE(refusal(as_text(through)).find("goes through itself"), std::string::npos);
  const Soup fin = joined(cube(0.0, 1.0), {{Vector{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}}});
  EXPECT_NE(refusal(as_text(fin)).find("has 2 open edges"), std::string::npos);
}

TEST(Surface, WhatIsNoStlIsRefused) {
  const std::string text = as_text(cube(0.0, 1.0)), binary = as_binary(cube(0.0, 1.0));
  for (const std::string& bad :
       {std::string(),
        std::string("hello"),
        text.substr(0, 700),
        binary.substr(0, 300),
        std::string(500, '\0'),
        std::string("solid a\nendsolid a\n")})
    EXPECT_NE(refusal(bad).find("is not a complete STL file"), std::string::npos) << bad.size();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}
std::string in_capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

TEST(Surface, WordsOfOtherProgramsAreRead) {
  const std::string text = as_text(cube(0.0, 2.0));
  const std::string variants[] = {
      text,
      in_capitals(text),
      "\xEF\xBB\xBF" + text,
      "\xEF\xBB\xBF\r\n  " + in_capitals(replaced(text, "\n", "\r\n")),
      replaced(text, "\n", "\r"),
      replaced(text, "endloop", "end loop"),
      replaced(text, "endfacet", "end facet"),
      replaced(text, "endsolid", "end solid"),
      replaced(replaced(text, "end", "End "), "vertex", "Vertex"),
      replaced(text, "endsolid", "endsolid facet of a solid"),
      "solid facet vertex endsolid" + text.substr(text.find('\n')),
      replaced(text, "normal 0 0 0", "normal nan nan -nan(ind)"),
      replaced(text, "vertex ", "\tvertex\t+"),
      replaced(text, "vertex ", "vertex\n"),
      text + text.substr(0, text.find('\n')) + "\nendsolid\n"};
  for (const std::string& variant : variants) {
    SCOPED_TRACE(variant.substr(0, 200));
    const auto surface = read(variant);
    EXPECT_EQ(surface->facets().size(), 12U);
    EXPECT_DOUBLE_EQ(surface->volume(), 8.0);
  }
}

/// The sentence has the line and the word.
TEST(Surface, WhatIsNoNumberIsNamedWithItsLine) {
  const std::string text = as_text(cube(0.0, 2.0));
  const std::size_t vertex = text.find("vertex ");
  const std::string line =
      std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<long>(vertex), '\n'));
  const auto spoilt = [&](const std::string& number) {
    std::string bad = text;
    bad.replace(vertex + 7, bad.find(' ', vertex + 7) - vertex - 7, number);
    return refusal(bad);
  };
  EXPECT_EQ(
      spoilt("0,5"),
      "part.stl: line " + line +
          " has 0,5 (STL files have decimal points, no commas); export it with points."
  );
  for (const char* word : {"nan", "inf", "-nan(ind)", "1e999", "1.#QNAN", "0.5mm", "x"}) {
    const std::string said = spoilt(word);
    EXPECT_NE(said.find("part.stl: line " + line + " has "), std::string::npos) << said;
    EXPECT_NE(said.find(word), std::string::npos) << said;
  }
  EXPECT_NE(
      refusal(replaced(text, "outer loop", "outer lop")).find("has \"lop\" where \"loop\""),
      std::string::npos
  );
  EXPECT_NE(refusal("\xFF\xFEs").find("UTF-16"), std::string::npos);
}

TEST(Surface, BytesAtRandomAreRefusedOrRead) {
  std::mt19937 random(11);
  const std::string text = as_text(cube(0.0, 1.0)), binary = as_binary(cube(0.0, 1.0));
  int refused = 0;
  for (int k = 0; k < 400; ++k) {
    std::string spoilt = k % 2 == 0 ? text : binary;
    for (int j = 0; j < 3; ++j)
      spoilt[random() % spoilt.size()] = static_cast<char>(random() % 256);
    refused += refusal(spoilt) == "read" ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace barreno
