// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

namespace barreno::arenisca::outside {

/// A shear limit that bends over to a strength of its own, with d = PEAKI1 - x:
///
///   Ff = FSLOPE d/(1 + FSLOPE d/S)
///
/// Source: N. Lundborg, Strength of rock-like materials, Int. J. Rock Mech. Min. Sci. 5 (1968).
/// PEAKI1 and FSLOPE are the published parameters.
struct LundborgLimit {
  struct Parameters {
    double lundborg_strength;
  };
  static ParameterTable<Parameters> parameter_table() {
    return {
        {optional(
            &Parameters::lundborg_strength,
            "Lundborg strength",
            dimension::stress,
            at_least(0.0),
            0.0,
            "S: shear strength at high pressure; 0: the published limit"
        )},
        {}};
  }
  static constexpr const char* word = "Lundborg strength";
  template <class P>
  static bool asked(const P& p) {
    return p.lundborg_strength > 0.0;
  }
  template <class P>
  static std::string check(const P& p) {
    if (!asked(p) || (p.STREN == 0.0 && p.YSLOPE == 0.0 && p.FSLOPE > 0.0)) return {};
    return named("Lundborg strength", p.lundborg_strength) +
           " needs FSLOPE, and takes the place of STREN and YSLOPE; leave those out.";
  }
  /// A sound card with it.
  template <class P>
  static void ask(P& p) {
    p.STREN = p.YSLOPE = 0.0;
    p.lundborg_strength = 5e8;
  }

  template <class P>
  static double peak(const P& p) {
    return p.PEAKI1;
  }
  template <class P>
  static double largest_factor(const P& /*p*/) {
    return HUGE_VAL;
  }

  template <class R>
  struct Of {
    R slope{}, per_strength{};  ///< FSLOPE, FSLOPE/S
    R peak{}, vertex{}, steepest{};
    bool straight = false;

    template <class X>
    BARRENO_FUNCTION LimitOf<X> limit_at(const X& x) const {
      const X d = peak - x;
      const X part = 1.0 / (1.0 + per_strength * d);
      const X value = slope * d * part, fall = -slope * part * part;
      return {value, fall, X(2.0 * per_strength * part * fall)};
    }
    template <class X>
    BARRENO_FUNCTION X curvature(const X& curved) const {
      return curved;
    }
    template <class X>
    BARRENO_FUNCTION X lower_bound(const X& x) const {
      return limit_at(x).value;
    }
    /// @param gamma  times as strong at the same pressure
    BARRENO_FUNCTION void scale(const R& gamma) {
      slope = gamma * slope;
      steepest = gamma * steepest;
    }
  };
  template <class P, class R>
  BARRENO_FUNCTION static Of<R> make(const P& p, const R& peak) {
    const double slope = p.FSLOPE;
    return {R{} + slope, R{} + slope / p.lundborg_strength, peak, peak, R{} + slope, false};
  }
  template <class R>
  BARRENO_FUNCTION static Of<R> same(const Of<double>& one) {
    return {
        R{} + one.slope,
        R{} + one.per_strength,
        R{} + one.peak,
        R{} + one.vertex,
        R{} + one.steepest,
        false};
  }
};

}  // namespace barreno::arenisca::outside
