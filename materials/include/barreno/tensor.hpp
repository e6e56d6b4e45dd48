// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"
#include "barreno/select_members.hpp"

#include <cmath>

namespace barreno {

/// Symmetric tensor, components in the order of files and interfaces: xx yy zz xy yz zx (tensor
/// shear).
template <class R>
struct Sym3Of {
  using Real = R;
  R xx{}, yy{}, zz{}, xy{}, yz{}, zx{};
};
using Sym3 = Sym3Of<double>;

/// General 3x3 tensor, a(i, j) = row i, column j.
struct Mat3 {
  double a[3][3]{};
  BARRENO_FUNCTION double& operator()(int i, int j) { return a[i][j]; }
  BARRENO_FUNCTION double operator()(int i, int j) const { return a[i][j]; }
};

template <class R>
BARRENO_FUNCTION Sym3Of<R> operator+(const Sym3Of<R>& s, const Sym3Of<R>& t) {
  return {s.xx + t.xx, s.yy + t.yy, s.zz + t.zz, s.xy + t.xy, s.yz + t.yz, s.zx + t.zx};
}
template <class R>
BARRENO_FUNCTION Sym3Of<R> operator-(const Sym3Of<R>& s, const Sym3Of<R>& t) {
  return {s.xx - t.xx, s.yy - t.yy, s.zz - t.zz, s.xy - t.xy, s.yz - t.yz, s.zx - t.zx};
}
template <class C, class R>
BARRENO_FUNCTION Sym3Of<R> operator*(const C& c, const Sym3Of<R>& s) {
  return {c * s.xx, c * s.yy, c * s.zz, c * s.xy, c * s.yz, c * s.zx};
}
template <class R>
BARRENO_FUNCTION R trace(const Sym3Of<R>& s) {
  return s.xx + s.yy + s.zz;
}

/// s : t, shear components counted twice.
template <class R>
BARRENO_FUNCTION R contract(const Sym3Of<R>& s, const Sym3Of<R>& t) {
  return s.xx * t.xx + s.yy * t.yy + s.zz * t.zz + 2.0 * (s.xy * t.xy + s.yz * t.yz + s.zx * t.zx);
}
template <class R>
BARRENO_FUNCTION Sym3Of<R> isotropic(const R& c) {
  return {c, c, c, R{}, R{}, R{}};
}
template <class R>
BARRENO_FUNCTION Sym3Of<R> deviator(const Sym3Of<R>& s) {
  return s - isotropic(R(trace(s) / 3.0));
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
template <class R>
BARRENO_FUNCTION MaskOf<R> is_finite(const Sym3Of<R>& s) {
  return real::is_finite(R(s.xx + s.yy + s.zz + s.xy + s.yz + s.zx));
}

}  // namespace barreno
