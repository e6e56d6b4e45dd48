// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Hydrostatic strength X (value of I1 < 0 at which the rock crushes) against the volumetric
/// plastic strain evp:
///
///   evp <= 0:  X = p0 + ln(1 + evp/p3) / p1                compaction, X -> -infinity at evp = -p3
///   evp >  0:  X = p0 (1 + evp)^(1/(p0 p1 p3))             dilation retracts the cap; C1 at evp =
///   0
///
/// p3 = 0 is nonporous rock without cap, its own case: the dilation branch has no limit for p3 ->
/// 0.
struct CrushCurve {
  double p0, p1, p3;

  /// Fraction of the pore strain below which the pores count as closed. The stored evp fixes ln(1 +
  /// evp/p3) to eps/fraction only: at 1e-5 the cap's place still has 11 digits, and the strain left
  /// out, 1e-5 p3, is far below the tolerance.
  static constexpr double closed_fraction = 1e-5;
  /// The cap retracts no further than this fraction of p0, so that rock without strength keeps an
  /// elastic domain with an interior.
  static constexpr double retraction_limit = 1e-12;

  BARRENO_FUNCTION double open_fraction(double evp) const { return 1.0 + evp / p3; }

  /// True where the surface has a cap: porous rock whose pores are not all closed.
  BARRENO_FUNCTION bool has_cap(double evp) const {
    return p3 > 0.0 && open_fraction(evp) > closed_fraction;
  }

  /// X(evp); asks has_cap(evp) [stress].
  BARRENO_FUNCTION double strength(double evp) const {
    if (evp == 0.0) return p0;
    if (evp < 0.0) return p0 + std::log1p(evp / p3) / p1;
    const double ratio = std::exp(std::log1p(evp) / (p0 * p1 * p3));
    return p0 * std::fmax(ratio, retraction_limit);
  }

  /// Inverse of strength(): evp(X) for X < 0.
  BARRENO_FUNCTION double plastic_strain(double X) const {
    if (X <= p0) return p3 * std::expm1(p1 * (X - p0));
    return std::expm1(p0 * p1 * p3 * std::log(X / p0));
  }

  /// Smallest evp with a cap; asks p3 > 0.
  BARRENO_FUNCTION double last_open() const { return -p3 * (1.0 - 1.001 * closed_fraction); }
};

/// Quotients of a curve's parameters, for updates that would divide often; meaningless for p3 = 0.
struct CrushRates {
  double per_p1 = 0.0;    ///< 1/p1 [stress]
  double per_p3 = 0.0;    ///< 1/p3
  double power = 0.0;     ///< 1/(p0 p1 p3)
  double at_start = 0.0;  ///< dX/d(evp) at evp = 0: 1/(p1 p3) [stress]
};
BARRENO_FUNCTION CrushRates crush_rates(const CrushCurve& c) {
  if (c.p3 == 0.0) return {};
  return {1.0 / c.p1, 1.0 / c.p3, 1.0 / (c.p0 * c.p1 * c.p3), 1.0 / (c.p1 * c.p3)};
}

}  // namespace barreno::arenisca
