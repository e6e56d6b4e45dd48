// SPDX-License-Identifier: BSD-3-Clause
#include "drive/matrix.hpp"

#include "base/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

template <class F>
Mat3 entries(F&& f) {
  Mat3 m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = f(i, j);
  return m;
}

/// Both iterations double the digits of each round: a change of this size was the last that counts.
constexpr double settled = 1e-9;

/// Square root by the product-free iteration of Denman and Beavers: x -> a^1/2, y -> a^-1/2.
Mat3 square_root(const Mat3& a) {
  constexpr int most = 60;  // half a turn has no real root: the iteration does not converge
  Mat3 x = a, y = identity();
  for (int i = 0; i < most; ++i) {
    const Mat3 next = 0.5 * (x + inverse(y));
    y = 0.5 * (y + inverse(x));
    const double change = norm(next - x);
    x = next;
    if (!(change > settled * norm(x))) break;
  }
  return x;
}

/// Imaginary part of the complex eigenvalues of a, 0 when all are real: Cardano's formula for
/// l^3 + p l + q of the traceless part.
double spin(const Mat3& a) {
  const Mat3 b = a - ((a(0, 0) + a(1, 1) + a(2, 2)) / 3.0) * identity();
  const Mat3 square = b * b;
  const double p = -0.5 * (square(0, 0) + square(1, 1) + square(2, 2));
  const double q = -determinant(b);
  const double discriminant = 0.25 * q * q + p * p * p / 27.0;
  if (!(discriminant > 0.0)) return 0.0;
  const double root = std::sqrt(discriminant);
  return 0.5 * std::sqrt(3.0) * (std::cbrt(root - 0.5 * q) + std::cbrt(root + 0.5 * q));
}

}  // namespace

Mat3 identity() {
  return entries([](int i, int j) { return i == j ? 1.0 : 0.0; });
}
Mat3 operator+(const Mat3& a, const Mat3& b) {
  return entries([&](int i, int j) { return a(i, j) + b(i, j); });
}
Mat3 operator-(const Mat3& a, const Mat3& b) {
  return entries([&](int i, int j) { return a(i, j) - b(i, j); });
}
Mat3 operator*(double c, const Mat3& a) {
  return entries([&](int i, int j) { return c * a(i, j); });
}
Mat3 operator*(const Mat3& a, const Mat3& b) {
  return entries([&](int i, int j) {
    return a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  });
}
Mat3 transpose(const Mat3& a) {
  return entries([&](int i, int j) { return a(j, i); });
}

double determinant(const Mat3& a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
         a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

double norm(const Mat3& a) {
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double sum = std::abs(a(i, 0)) + std::abs(a(i, 1)) + std::abs(a(i, 2));
    if (!(sum <= largest)) largest = sum;
  }
  return largest;
}

Mat3 inverse(const Mat3& a) {
  const double scale = 1.0 / determinant(a);
  return entries([&](int i, int j) {
    // Cofactor of entry (j, i); the cyclic order of the others carries the sign.
    const int k = (j + 1) % 3, l = (j + 2) % 3, m = (i + 1) % 3, n = (i + 2) % 3;
    return scale * (a(k, m) * a(l, n) - a(k, n) * a(l, m));
  });
}

std::optional<Mat3> logarithm_1p(const Mat3& g) {
  constexpr double small = 0.25;
  constexpr int max_roots = 40, terms = 12;
  Mat3 rest = g;
  double factor = 2.0;
  for (int i = 0; i < max_roots && norm(rest) > small; ++i) {
    rest = square_root(identity() + rest) - identity();
    factor *= 2.0;
  }
  const Mat3 z = rest * inverse(2.0 * identity() + rest);
  const Mat3 square = z * z;
  Mat3 sum = (1.0 / (2 * terms + 1)) * identity();
  for (int k = terms - 1; k >= 0; --k) sum = (1.0 / (2 * k + 1)) * identity() + square * sum;
  const Mat3 log = factor * (z * sum);
  // Nearer to half a turn round-off decides which way it went.
  constexpr double half_turn = pi - 1e-5;
  if (!(spin(log) < half_turn)) return std::nullopt;
  // A root that was not found shows here, whatever came of it.
  const Mat3 target = identity() + g;
  constexpr double lost = 1e-9;
  if (!(norm(exponential(log) - target) <= lost * norm(target))) return std::nullopt;
  return log;
}

Mat3 exponential(const Mat3& a) {
  constexpr double small = 0.1;
  constexpr int terms = 12, most = 60;
  int squarings = 0;
  double scale = 1.0;
  while (squarings < most && !(norm(a) * scale <= small)) {
    scale *= 0.5;
    ++squarings;
  }
  const Mat3 part = scale * a;
  Mat3 sum = identity();
  for (int k = terms; k >= 1; --k) sum = identity() + (1.0 / k) * (part * sum);
  for (int i = 0; i < squarings; ++i) sum = sum * sum;
  return sum;
}

Mat3 polar_rotation(const Mat3& f) {
  constexpr int most = 100;
  Mat3 r = f;
  for (int i = 0; i < most; ++i) {
    const Mat3 inverse_transpose = transpose(inverse(r));
    // Far from a rotation the scaled step is the shorter way; near one it is the plain step.
    const double c = std::sqrt(norm(inverse_transpose) / norm(r));
    const double scale = c > 0.5 && c < 2.0 ? 1.0 : c;
    const Mat3 next = 0.5 * (scale * r + (1.0 / scale) * inverse_transpose);
    const double change = norm(next - r);
    r = next;
    if (!(change > settled)) break;
  }
  return r;
}

Sym3 rotate(const Mat3& r, const Sym3& t) {
  return symmetric_part(r * full(t) * transpose(r));
}

Sym3 unrotate(const Mat3& r, const Sym3& t) {
  return rotate(transpose(r), t);
}

}  // namespace barreno
