// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/tensor.hpp"

namespace barreno {

/// a b of two symmetric tensors that commute (functions of one tensor): symmetric again.
BARRENO_FUNCTION Sym3 commuting_product(const Sym3& a, const Sym3& b) {
  return {
      a.xx * b.xx + a.xy * b.xy + a.zx * b.zx,
      a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
      a.zx * b.zx + a.yz * b.yz + a.zz * b.zz,
      a.xx * b.xy + a.xy * b.yy + a.zx * b.yz,
      a.xy * b.zx + a.yy * b.yz + a.yz * b.zz,
      a.zx * b.xx + a.yz * b.xy + a.zz * b.zx};
}

BARRENO_FUNCTION Mat3 full(const Sym3& s) {
  return {{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}}};
}
BARRENO_FUNCTION Mat3 product(const Mat3& a, const Mat3& b) {
  Mat3 out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) out(i, j) += a(i, k) * b(k, j);
  return out;
}
BARRENO_FUNCTION Sym3 symmetric_part(const Mat3& m) {
  return {
      m(0, 0),
      m(1, 1),
      m(2, 2),
      0.5 * (m(0, 1) + m(1, 0)),
      0.5 * (m(1, 2) + m(2, 1)),
      0.5 * (m(2, 0) + m(0, 2))};
}
/// u s u, for two symmetric tensors.
BARRENO_FUNCTION Sym3 congruent(const Sym3& u, const Sym3& s) {
  return symmetric_part(product(product(full(u), full(s)), full(u)));
}

/// Inverse by cofactors; not finite for a singular tensor.
BARRENO_FUNCTION Sym3 inverse(const Sym3& s) {
  return (1.0 / determinant(s)) * Sym3{
                                      s.yy * s.zz - s.yz * s.yz,
                                      s.xx * s.zz - s.zx * s.zx,
                                      s.xx * s.yy - s.xy * s.xy,
                                      s.yz * s.zx - s.xy * s.zz,
                                      s.xy * s.zx - s.xx * s.yz,
                                      s.xy * s.yz - s.yy * s.zx};
}

/// Square root of a positive definite symmetric tensor, by Newton's iteration in the stable form of
/// Denman and Beavers: Y <- (Y + Z^-1)/2, Z <- (Z + Y^-1)/2, Y -> A^(1/2), Z -> A^(-1/2).
/// Not finite, or any value, for a tensor without one.
/// Source: E. Denman, A. Beavers, Appl. Math. Comput. 2 (1976) 63-94.
BARRENO_FUNCTION Sym3 square_root(const Sym3& a) {
  constexpr int max_iterations = 40;
  constexpr double nearly = 1e-8;  // the next iteration is exact to round-off
  Sym3 y = a;
  Sym3 z = isotropic(1.0);
  for (int i = 0; i < max_iterations; ++i) {
    const Sym3 next = 0.5 * (y + inverse(z));
    z = 0.5 * (z + inverse(y));
    const double change = norm(next - y);
    y = next;
    if (!(change > nearly * norm(y))) break;
  }
  return 0.5 * (y + inverse(z));
}

/// exp(A) - I of a symmetric tensor: power series of A / 2^n, then n doublings E <- E^2 + 2 E.
/// Exactly zero for A = 0.
BARRENO_FUNCTION Sym3 exponential_less_one(const Sym3& a) {
  constexpr double small = 0.1;  // terms beyond A^10 are below round-off
  constexpr int terms = 10;
  int doublings = 0;
  Sym3 x = a;
  for (double size = norm(a); size > small && doublings < 64; size *= 0.5) {
    x = 0.5 * x;
    ++doublings;
  }
  Sym3 e = x;
  Sym3 term = x;
  for (int k = 2; k <= terms; ++k) {
    term = (1.0 / k) * commuting_product(term, x);
    e = e + term;
  }
  for (int i = 0; i < doublings; ++i) e = commuting_product(e, e) + 2.0 * e;
  return e;
}

}  // namespace barreno
