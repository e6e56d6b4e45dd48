// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>

namespace barreno {

/// Symmetric tensor, components in the order of files and interfaces: xx yy zz xy yz zx (tensor
/// shear).
struct Sym3 {
  double xx{}, yy{}, zz{}, xy{}, yz{}, zx{};
};

/// General 3x3 tensor, a(i, j) = row i, column j.
struct Mat3 {
  double a[3][3]{};
  BARRENO_FUNCTION double& operator()(int i, int j) { return a[i][j]; }
  BARRENO_FUNCTION double operator()(int i, int j) const { return a[i][j]; }
};

BARRENO_FUNCTION Sym3 operator+(const Sym3& s, const Sym3& t) {
  return {s.xx + t.xx, s.yy + t.yy, s.zz + t.zz, s.xy + t.xy, s.yz + t.yz, s.zx + t.zx};
}
BARRENO_FUNCTION Sym3 operator-(const Sym3& s, const Sym3& t) {
  return {s.xx - t.xx, s.yy - t.yy, s.zz - t.zz, s.xy - t.xy, s.yz - t.yz, s.zx - t.zx};
}
BARRENO_FUNCTION Sym3 operator*(double c, const Sym3& s) {
  return {c * s.xx, c * s.yy, c * s.zz, c * s.xy, c * s.yz, c * s.zx};
}
BARRENO_FUNCTION double trace(const Sym3& s) {
  return s.xx + s.yy + s.zz;
}

/// s : t, shear components counted twice.
BARRENO_FUNCTION double contract(const Sym3& s, const Sym3& t) {
  return s.xx * t.xx + s.yy * t.yy + s.zz * t.zz + 2.0 * (s.xy * t.xy + s.yz * t.yz + s.zx * t.zx);
}
BARRENO_FUNCTION Sym3 isotropic(double c) {
  return {c, c, c, 0.0, 0.0, 0.0};
}
BARRENO_FUNCTION Sym3 deviator(const Sym3& s) {
  return s - isotropic(trace(s) / 3.0);
}
BARRENO_FUNCTION double norm(const Sym3& s) {
  return std::sqrt(contract(s, s));
}

/// Second invariant of a deviator: J2 = s : s / 2.
BARRENO_FUNCTION double second_invariant(const Sym3& s) {
  return 0.5 * contract(s, s);
}
BARRENO_FUNCTION double determinant(const Sym3& s) {
  return s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.zx) +
         s.zx * (s.xy * s.yz - s.yy * s.zx);
}
BARRENO_FUNCTION bool is_finite(const Sym3& s) {
  return std::isfinite(s.xx + s.yy + s.zz + s.xy + s.yz + s.zx);
}

}  // namespace barreno
