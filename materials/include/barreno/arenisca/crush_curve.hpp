// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/selection.hpp"
#include "barreno/real.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Point of a crush curve. X and slope mean nothing where the pores are closed.
template <class R>
struct CrushedOf {
  MaskOf<R> open{};  ///< porous rock whose pores are not all closed
  R X{};             ///< hydrostatic strength [stress]
  R slope{};         ///< dX/d(evp) [stress]
};

/// Hydrostatic strength X (value of I1 < 0 at which the rock crushes) against the volumetric
/// plastic strain evp, of one point or several (real.hpp):
///
///   evp <= 0:  X = p0 + ln(1 + evp/p3) / p1                compaction, X -> -infinity at evp = -p3
///   evp >  0:  X = p0 (1 + evp)^(1/(p0 p1 p3))             dilation retracts the cap; C1 at evp =
///   0
///
/// p3 = 0 is nonporous rock without cap, its own case: the dilation branch has no limit for p3 ->
/// 0.
struct CrushCurve {
  double p0 = 0.0, p1 = 0.0, p3 = 0.0;
  /// Quotients of those, for updates that would divide often; 0 for p3 = 0.
  double per_p1 = 0.0;    ///< 1/p1 [stress]
  double per_p3 = 0.0;    ///< 1/p3
  double power = 0.0;     ///< 1/(p0 p1 p3)
  double at_start = 0.0;  ///< dX/d(evp) at evp = 0: 1/(p1 p3) [stress]

  /// Fraction of the pore strain below which the pores count as closed. The stored evp fixes ln(1 +
  /// evp/p3) to eps/fraction only: at 1e-5 the cap's place still has 11 digits, and the strain left
  /// out, 1e-5 p3, is far below the tolerance.
  static constexpr double closed_fraction = 1e-5;
  /// The cap retracts no further than this fraction of p0, so that rock without strength keeps an
  /// elastic domain with an interior.
  static constexpr double retraction_limit = 1e-12;

  CrushCurve() = default;
  CrushCurve(double start, double steepness, double pore_strain)
      : p0(start), p1(steepness), p3(pore_strain) {
    if (p3 == 0.0) return;
    per_p1 = 1.0 / p1;
    per_p3 = 1.0 / p3;
    power = 1.0 / (p0 * p1 * p3);
    at_start = 1.0 / (p1 * p3);
  }

  template <class R>
  BARRENO_FUNCTION CrushedOf<R> at(const R& evp) const {
    CrushedOf<R> c{none_of<R>()};
    if (p3 == 0.0) return c;
    const R open_fraction = 1.0 + per_p3 * evp;
    c.open = open_fraction > closed_fraction;
    const MaskOf<R> dilates = evp > 0.0;
    const R argument = real::select(dilates, 1.0 + evp, real::select(c.open, open_fraction, 1.0));
    const R logarithm = real::log(argument);
    c.X = p0 + per_p1 * logarithm;
    c.slope = at_start / argument;
    if (real::any(dilates)) {
      const R ratio = real::larger(real::exp(R(power * logarithm)), retraction_limit);
      c.X = real::select(dilates, p0 * ratio, c.X);
      c.slope = real::select(dilates, ratio * c.slope, c.slope);
    }
    return c;
  }

  /// True where the surface has a cap.
  BARRENO_FUNCTION bool has_cap(double evp) const { return at(evp).open; }
  /// X(evp); asks has_cap(evp) [stress].
  BARRENO_FUNCTION double strength(double evp) const { return at(evp).X; }

  /// Inverse of strength(): evp(X) for X < 0.
  BARRENO_FUNCTION double plastic_strain(double X) const {
    if (X <= p0) return p3 * std::expm1(p1 * (X - p0));
    return std::expm1(p0 * p1 * p3 * std::log(X / p0));
  }

  /// Smallest evp with a cap; asks p3 > 0.
  BARRENO_FUNCTION double last_open() const { return -p3 * (1.0 - 1.001 * closed_fraction); }
  /// evp of rock whose pores crushing has closed altogether: more cannot be crushed.
  BARRENO_FUNCTION double closed() const { return -p3; }
};

}  // namespace barreno::arenisca
