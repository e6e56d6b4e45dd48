// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
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

/// Whether the strength is a concave function of the plastic strain.
template <class Crush>
inline constexpr bool is_concave = true;

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
  struct Parameters {
    double p0_crush_curve, p1_crush_curve, p3_crush_curve;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::p0_crush_curve,
             "p0_crush_curve",
             d::stress,
             any(),
             0.0,
             "I1 at which crushing begins; needed unless p3_crush_curve = 0"
         ),
         optional(
             &P::p1_crush_curve,
             "p1_crush_curve",
             d::compliance,
             any(),
             0.0,
             "steepness of the crush curve; needed unless p3_crush_curve = 0"
         ),
         required(
             &P::p3_crush_curve, "p3_crush_curve", d::none, at_least(0.0), "-ln(1 - porosity)"
         )},
        {}};
  }
  static std::string check(const Parameters& p) {
    if (p.p3_crush_curve == 0.0) return {};  // nonporous: no cap, p0 and p1 are not read
    if (!(p.p0_crush_curve < 0.0)) {
      return named("p0_crush_curve", p.p0_crush_curve) +
             " must be negative (it is the I1 at which crushing begins, tension positive); change "
             "its sign, or "
             "set p3_crush_curve = 0 for nonporous rock.";
    }
    if (!(p.p1_crush_curve > 0.0)) {
      return named("p1_crush_curve", p.p1_crush_curve) +
             " must be positive (else crushing softens the rock); change its sign, or set "
             "p3_crush_curve = 0 for "
             "nonporous rock.";
    }
    return {};
  }

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

  explicit CrushCurve(const Parameters& p)
      : CrushCurve(p.p0_crush_curve, p.p1_crush_curve, p.p3_crush_curve) {}

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

  /// Rock with pores to crush.
  BARRENO_FUNCTION bool porous() const { return p3 != 0.0; }
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
