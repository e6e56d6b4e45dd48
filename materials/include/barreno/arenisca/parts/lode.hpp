// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/arenisca/root_finding.hpp"
#include "barreno/portability.hpp"
#include "barreno/real.hpp"
#include "barreno/tensor.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Dependence of the strength on the third invariant: sqrt(J2) <= Gamma(theta) Ff fc.
///
/// theta is 0 in triaxial extension and pi/3 in triaxial compression; Gamma(pi/3) = 1, Gamma(0) =
/// psi. Convex for 7/9 <= psi <= 9/7 (Gudehus) and 1/2 <= psi <= 2 (others).
struct Lode {
  struct Parameters {
    double J3_psi;
    int J3_type;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
            &P::J3_psi,
            "J3_psi",
            d::none,
            Bounds{0.5, 2.0, false, false},
            1.0,
            "strength in triaxial extension over that in compression"
        )},
        {{&P::J3_type,
          "J3_type",
          {"none", "Gudehus", "Willam-Warnke", "Mohr-Coulomb"},
          0,
          "dependence of the strength on the Lode angle"}}};
  }
  static std::string check(const Parameters& p) {
    constexpr double widest = 9.0 / 7.0;
    const bool narrow = p.J3_type == 1;
    if (narrow && !(p.J3_psi >= 1.0 / widest && p.J3_psi <= widest)) {
      return named("J3_psi", p.J3_psi) +
             " makes the Gudehus surface concave (it is convex from 7/9 to 9/7); change it, or use "
             "Willam-Warnke, which is convex from 1/2 to 2.";
    }
    if (p.J3_type == 0 && p.J3_psi != 1.0) {
      return named("J3_psi", p.J3_psi) +
             " has no effect without a J3_type (the shape of the section between J3_psi and 1); "
             "set "
             "J3_type, or set J3_psi to 1.";
    }
    return {};
  }

  enum Kind { none = 0, gudehus = 1, willam_warnke = 2, mohr_coulomb = 3 };
  int kind = none;
  double psi = 1.0;

  static constexpr double third_turn = 1.0471975511965976;  ///< pi/3

  BARRENO_FUNCTION bool active() const {
    return kind == mohr_coulomb || (kind != none && psi != 1.0);
  }
  /// Gamma(theta) where it is least.
  BARRENO_FUNCTION double weakest() const {
    if (!active()) return 1.0;
    // A hexagon's sides are nearest to the axis at their feet.
    if (kind == mohr_coulomb)
      return 1.0 / std::hypot(1.0 / psi, (2.0 - 1.0 / psi) / std::sqrt(3.0));
    return smaller(psi, 1.0);
  }
  /// Gamma where it is most.
  BARRENO_FUNCTION double strongest() const { return active() ? larger(psi, 1.0) : 1.0; }
  struct Value {
    double gamma, slope;  ///< Gamma and dGamma/dtheta
  };
  BARRENO_FUNCTION Value at(double theta) const;
};

/// Gamma and its slope for one point or several, from the angle's cosine and sine.
template <class R>
struct LodeValueOf {
  R gamma, slope;
};

/// 1/Gamma from the cosine of 3 theta.
template <class R>
BARRENO_FUNCTION R gudehus_inverse(double psi, const R& c) {
  return 0.5 * ((1.0 - c) + (1.0 + c) * (1.0 / psi));
}
template <class R>
BARRENO_FUNCTION LodeValueOf<R> gudehus_at(double psi, const R& cosine, const R& sine) {
  const R c = cosine * (4.0 * cosine * cosine - 3.0), s = sine * (3.0 - 4.0 * sine * sine);
  const R u = gudehus_inverse(psi, c);
  const R slope = 1.5 * s * (1.0 - 1.0 / psi);
  return {1.0 / u, -slope / (u * u)};
}
/// An ellipse in the octahedral plane.
template <class R>
BARRENO_FUNCTION LodeValueOf<R> willam_warnke_at(double psi, const R& c, const R& s) {
  const double k = 1.0 - psi * psi, n = 2.0 * psi - 1.0;
  const R square = 4.0 * k * c * c + psi * (5.0 * psi - 4.0);
  const R root = real::sqrt(real::larger(square, 1e-300));
  const R root_slope = -4.0 * k * c * s / root;
  if (psi > 1.0) {
    // The same value rationalised: the form below is 0/0 within the range.
    const R bottom = 2.0 * k * c - n * root;
    const R value = (k - n * n) / bottom;
    return {value, -value * (-2.0 * k * s - n * root_slope) / bottom};
  }
  const R top = 2.0 * k * c + n * root, bottom = 4.0 * k * c * c + n * n;
  const R value = top / bottom;
  return {value, (-2.0 * k * s + n * root_slope + value * 8.0 * k * c * s) / bottom};
}
/// The straight line of Mohr-Coulomb's section in the octahedral plane: its foot, by angle, and its
/// distance from the axis over the strength in triaxial compression.
struct LodeLine {
  double cosine, sine, foot;
};
BARRENO_FUNCTION LodeLine line_of(const Lode& lode) {
  const double a = 1.0 / lode.psi, b = (2.0 - 1.0 / lode.psi) / std::sqrt(3.0);
  const double foot = 1.0 / std::hypot(a, b);
  return {a * foot, b * foot, foot};
}
/// A straight line in the octahedral plane.
template <class R>
BARRENO_FUNCTION LodeValueOf<R> mohr_coulomb_at(double psi, const R& c, const R& s) {
  const double a = 1.0 / psi, b = (2.0 - 1.0 / psi) / std::sqrt(3.0);
  const R u = a * c + b * s;
  return {1.0 / u, (a * s - b * c) / (u * u)};
}
template <class R>
BARRENO_FUNCTION LodeValueOf<R> lode_value(const Lode& lode, const R& cosine, const R& sine) {
  if (!lode.active()) return {R{} + 1.0, R{}};
  if (lode.kind == Lode::gudehus) return gudehus_at(lode.psi, cosine, sine);
  if (lode.kind == Lode::willam_warnke) return willam_warnke_at(lode.psi, cosine, sine);
  return mohr_coulomb_at(lode.psi, cosine, sine);
}

/// Gamma, Gamma'/Gamma and the derivative of that by the angle.
template <class R>
struct LodeBendOf {
  R gamma, bend, bend_slope;
};
/// Of Gamma = 1/u.
template <class R>
BARRENO_FUNCTION LodeBendOf<R> bend_of_inverse(const R& u, const R& du, const R& ddu) {
  const R gamma = 1.0 / u, bend = -du * gamma;
  return {gamma, bend, bend * bend - ddu * gamma};
}
template <class R>
BARRENO_FUNCTION LodeBendOf<R> willam_warnke_bend(double psi, const R& c, const R& s) {
  const double k = 1.0 - psi * psi, n = 2.0 * psi - 1.0;
  // The square under the root, and the root, each with two derivatives.
  const R square = 4.0 * k * c * c + psi * (5.0 * psi - 4.0);
  const R root = real::sqrt(real::larger(square, 1e-300)), per_root = 1.0 / root;
  const R dsquare = -8.0 * k * c * s, ddsquare = -8.0 * k * (c * c - s * s);
  const R droot = 0.5 * dsquare * per_root;
  const R ddroot = (0.5 * ddsquare - droot * droot) * per_root;
  if (psi > 1.0) {
    const double part = 1.0 / (k - n * n);
    return bend_of_inverse(
        R(part * (2.0 * k * c - n * root)),
        R(part * (-2.0 * k * s - n * droot)),
        R(part * (-2.0 * k * c - n * ddroot))
    );
  }
  const R top = 2.0 * k * c + n * root, per_top = 1.0 / top;
  const R per_bottom = 1.0 / (4.0 * k * c * c + n * n);
  const R dtop = (-2.0 * k * s + n * droot) * per_top, dbottom = dsquare * per_bottom;
  const R ddtop = (-2.0 * k * c + n * ddroot) * per_top;
  return {
      top * per_bottom,
      dtop - dbottom,
      ddtop - dtop * dtop - ddsquare * per_bottom + dbottom * dbottom};
}
template <class R>
BARRENO_FUNCTION LodeBendOf<R> lode_bend(const Lode& lode, const R& c, const R& s) {
  if (!lode.active()) return {R{} + 1.0, R{}, R{}};
  if (lode.kind == Lode::willam_warnke) return willam_warnke_bend(lode.psi, c, s);
  if (lode.kind == Lode::mohr_coulomb) {
    const double a = 1.0 / lode.psi, b = (2.0 - 1.0 / lode.psi) / std::sqrt(3.0);
    const R u = a * c + b * s;
    return bend_of_inverse(u, R(b * c - a * s), R(-u));
  }
  const double part = 1.0 - 1.0 / lode.psi;
  const R triple = c * (4.0 * c * c - 3.0), sine = s * (3.0 - 4.0 * s * s);
  return bend_of_inverse(
      R(0.5 * ((1.0 - triple) + (1.0 + triple) * (1.0 / lode.psi))),
      R(1.5 * part * sine),
      R(4.5 * part * triple)
  );
}

BARRENO_FUNCTION Lode::Value Lode::at(double theta) const {
  const LodeValueOf<double> v = lode_value(*this, std::cos(theta), std::sin(theta));
  return {v.gamma, v.slope};
}

/// theta in [0, pi/3] from cos 3 theta = (3 sqrt(3)/2) J3/J2^1.5.
BARRENO_FUNCTION double lode_angle(const Sym3& s) {
  const double J2 = second_invariant(s);
  if (J2 == 0.0) return 0.0;
  const double unit = 1.0 / std::sqrt(J2);
  const Sym3 n = unit * s;
  const double cosine = 1.5 * std::sqrt(3.0) * determinant(n);
  // Near the ends the cosine is flat: the sine from the invariants' discriminant keeps the digits.
  const double squared = 1.0 - cosine * cosine;
  return std::atan2(std::sqrt(larger(squared, 0.0)), cosine) / 3.0;
}

/// Direction in the octahedral plane at a right angle to the unit deviator n (n : n = 2) towards
/// larger theta, also with norm^2 = 2; needs theta inside (0, pi/3).
///
/// d s/d theta at constant J2: n2 = (2/sqrt(3)) [...] follows from the square of n less its trace
/// and less its part along n.
BARRENO_FUNCTION bool towards_larger_angle(const Sym3& n, Sym3& direction) {
  const Sym3 square = {
      n.xx * n.xx + n.xy * n.xy + n.zx * n.zx,
      n.xy * n.xy + n.yy * n.yy + n.yz * n.yz,
      n.zx * n.zx + n.yz * n.yz + n.zz * n.zz,
      n.xx * n.xy + n.xy * n.yy + n.zx * n.yz,
      n.xy * n.zx + n.yy * n.yz + n.yz * n.zz,
      n.xx * n.zx + n.xy * n.yz + n.zx * n.zz};
  Sym3 across = deviator(square);
  across = across - (0.5 * contract(across, n)) * n;
  const double length = std::sqrt(0.5 * contract(across, across));
  constexpr double axis = 1e-7;
  if (length < axis) return false;
  // The square's deviator points to triaxial extension (theta = 0): larger theta is the other way.
  direction = (-1.0 / length) * across;
  return true;
}

/// The deviator of s turned within its own octahedral plane by `turn` towards larger theta and
/// scaled to sqrt(J2) = q. On the axes of the plane (theta = 0 or pi/3) it cannot turn.
BARRENO_FUNCTION Sym3 turned(const Sym3& s, double turn, double q) {
  const double J2 = second_invariant(s);
  if (J2 == 0.0) return 0.0 * s;
  const Sym3 n = (1.0 / std::sqrt(J2)) * s;
  Sym3 across;
  if (turn == 0.0 || !towards_larger_angle(n, across)) return q * n;
  return (q * std::cos(turn)) * n + (q * std::sin(turn)) * across;
}

}  // namespace barreno::arenisca
