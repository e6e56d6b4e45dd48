// SPDX-License-Identifier: BSD-3-Clause
#include "state/ball_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace barreno {
namespace {

/// Area and first moments about the centre of the disk.
struct Moments {
  double area = 0.0, x = 0.0, y = 0.0;
};

/// Integrals from 0 to x of h, x h and h^2 with h = sqrt(R^2 - x^2).
struct Integrals {
  double h, xh, hh;
};
Integrals integrals(double radius, double x) {
  const double h = std::sqrt(std::max(0.0, radius * radius - x * x));
  const double angle = std::asin(std::clamp(x / radius, -1.0, 1.0));
  return {
      0.5 * (x * h + radius * radius * angle),
      (radius * radius * radius - h * h * h) / 3.0,
      radius * radius * x - x * x * x / 3.0};
}

/// Part of the disk between x = a and x = b, where its lower and its upper bound are each either
/// the rectangle's edge or the circle; `r` has the disk's centre as origin.
Moments strip(double radius, const Box& r, double a, double b) {
  const double middle = 0.5 * (a + b);
  const double h = std::sqrt(std::max(0.0, radius * radius - middle * middle));
  const double low = r.lower[1], high = r.upper[1];
  if (std::min(high, h) <= std::max(low, -h)) return {};
  const Integrals to = integrals(radius, b), from = integrals(radius, a);
  const double length = b - a, first = 0.5 * (b * b - a * a);
  Moments m;
  const auto add = [&](double sign, bool circle, double side, double edge) {
    m.area += sign * (circle ? side * (to.h - from.h) : edge * length);
    m.x += sign * (circle ? side * (to.xh - from.xh) : edge * first);
    m.y += sign * 0.5 * (circle ? to.hh - from.hh : edge * edge * length);
  };
  add(1.0, h < high, 1.0, high);
  add(-1.0, -h > low, -1.0, low);
  return m;
}

Moments disk_moments(double radius, const Box& r) {
  if (!(radius > 0.0)) return {};
  std::array<double, 8> breaks{r.lower[0], r.upper[0], -radius, radius};
  int i = 4;
  for (const double y : {r.lower[1], r.upper[1]}) {
    const double x = std::sqrt(std::max(0.0, radius * radius - y * y));
    breaks[static_cast<std::size_t>(i++)] = -x;
    breaks[static_cast<std::size_t>(i++)] = x;
  }
  const double from = std::max(r.lower[0], -radius), to = std::min(r.upper[0], radius);
  for (double& x : breaks) x = std::clamp(x, from, std::max(from, to));
  std::sort(breaks.begin(), breaks.end());
  Moments sum;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (!(breaks[k + 1] > breaks[k])) continue;
    const Moments part = strip(radius, r, breaks[k], breaks[k + 1]);
    sum.area += part.area;
    sum.x += part.x;
    sum.y += part.y;
  }
  return sum;
}

/// Part of a square below which a piece is a sliver.
constexpr double sliver = 0.25;

struct Square {
  long long i, j;
  bool operator==(const Square& other) const { return i == other.i && j == other.j; }
};

/// Squares that share an edge with this one and belong to the lattice.
std::vector<Square> neighbours(const Lattice& lattice, const Square& s) {
  std::vector<Square> squares;
  for (const Square& n : {Square{s.i - 1, s.j}, {s.i + 1, s.j}, {s.i, s.j - 1}, {s.i, s.j + 1}})
    if (n.i >= 0 && n.i < lattice.count[0] && n.j >= 0 && n.j < lattice.count[1])
      squares.push_back(n);
  return squares;
}

Piece piece_in(const Ball& ball, const Lattice& lattice, const Square& s) {
  const double x = lattice.lower[0] + static_cast<double>(s.i) * lattice.size;
  const double y = lattice.lower[1] + static_cast<double>(s.j) * lattice.size;
  return piece_of_ball(ball, {{x, y}, {x + lattice.size, y + lattice.size}});
}

/// The square whose particle holds the piece of this one.
Square holder(const Ball& ball, const Lattice& lattice, const Square& s, double area) {
  const double least = sliver * lattice.size * lattice.size;
  Square found = s;
  if (area >= least) return found;
  double fullest = least;
  for (const Square& n : neighbours(lattice, s)) {
    const double other = piece_in(ball, lattice, n).area;
    if (!(other >= fullest) || (other == fullest && !(found == s))) continue;
    fullest = other;
    found = n;
  }
  return found;
}

}  // namespace

Piece piece_of_ball(const Ball& ball, const Box& rectangle) {
  Box r = rectangle;
  double near = 0.0, far = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    r.lower[i] -= ball.centre[i];
    r.upper[i] -= ball.centre[i];
    const double nearest = std::clamp(0.0, r.lower[i], r.upper[i]);
    const double farthest = std::max(-r.lower[i], r.upper[i]);
    near += nearest * nearest;
    far += farthest * farthest;
  }
  const double outer = ball.radius * ball.radius, inner = ball.inner_radius * ball.inner_radius;
  const double middle_x = 0.5 * (rectangle.lower[0] + rectangle.upper[0]);
  const double middle_y = 0.5 * (rectangle.lower[1] + rectangle.upper[1]);
  const double edge = (r.upper[0] - r.lower[0]) * (r.upper[1] - r.lower[1]);
  if (near >= outer || far <= inner) return {};
  if (far <= outer && near >= inner) return {edge, middle_x, middle_y};
  const Moments whole = disk_moments(ball.radius, r), hollow = disk_moments(ball.inner_radius, r);
  const double area = whole.area - hollow.area;
  // Less than this is round-off of the difference, and no particle.
  constexpr double least = 1e-9;
  if (!(area > least * edge)) return {};
  return {
      area,
      ball.centre[0] + (whole.x - hollow.x) / area,
      ball.centre[1] + (whole.y - hollow.y) / area};
}

Piece ball_particle(const Ball& ball, const Lattice& lattice, long long i, long long j) {
  const Square own{i, j};
  Piece sum = piece_in(ball, lattice, own);
  if (!(sum.area > 0.0) || !(holder(ball, lattice, own, sum.area) == own)) return {};
  for (const Square& n : neighbours(lattice, own)) {
    const Piece piece = piece_in(ball, lattice, n);
    if (!(piece.area > 0.0) || !(holder(ball, lattice, n, piece.area) == own)) continue;
    const double area = sum.area + piece.area;
    sum.x += piece.area / area * (piece.x - sum.x);
    sum.y += piece.area / area * (piece.y - sum.y);
    sum.area = area;
  }
  return sum;
}

}  // namespace barreno
