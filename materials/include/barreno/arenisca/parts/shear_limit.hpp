// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/real.hpp"

#include <cmath>
#include <limits>

namespace barreno::arenisca {

/// Limit function at I1 = x: value and slope [stress], and what curvature() takes.
template <class R>
struct LimitOf {
  R value, slope, curved;
};

/// The published shear limit, nonlinear Drucker-Prager:
///
///   Ff = a1 - a3 exp(a2 x) - a4 x
///
/// with the cases that check() admits: linear Drucker-Prager (STREN = YSLOPE = 0), von Mises (STREN
/// only), nonlinear Drucker-Prager (else; with PEAKI1 = YSLOPE = 0 it is the "zero vertex to von
/// Mises" surface). A shear limit is concave and falls with x, so that with its cap it bounds a
/// convex set.
struct ShearLimit {
  struct Parameters {
    double PEAKI1, FSLOPE, STREN, YSLOPE;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {required(&P::PEAKI1, "PEAKI1", d::stress, at_least(0.0), "I1 at the tensile vertex"),
         required(
             &P::FSLOPE,
             "FSLOPE",
             d::none,
             at_least(0.0),
             "slope of the limit surface at the vertex"
         ),
         optional(
             &P::STREN, "STREN", d::stress, at_least(0.0), 0.0, "shear strength at high pressure"
         ),
         optional(&P::YSLOPE, "YSLOPE", d::none, at_least(0.0), 0.0, "slope at high pressure")},
        {}};
  }
  static std::string check(const Parameters& p) {
    const std::string FSLOPE = named("FSLOPE", p.FSLOPE), STREN = named("STREN", p.STREN);
    const std::string PEAKI1 = named("PEAKI1", p.PEAKI1), YSLOPE = named("YSLOPE", p.YSLOPE);
    if (p.FSLOPE == 0.0 && p.STREN == 0.0) {
      return FSLOPE + " and " + STREN +
             " leave the rock without any shear strength (the yield surface is "
             "empty); set FSLOPE, STREN or both.";
    }
    if (p.FSLOPE == 0.0 && p.PEAKI1 != 0.0) {
      return PEAKI1 +
             " needs a slope, but FSLOPE = 0 (STREN alone is the von Mises surface, which has no "
             "vertex); set FSLOPE, or PEAKI1 = 0.";
    }
    if (p.FSLOPE == 0.0 && p.YSLOPE != 0.0) {
      return YSLOPE +
             " exceeds FSLOPE = 0 (the limit surface would open backwards); set FSLOPE, or YSLOPE "
             "= "
             "0 "
             "for von Mises.";
    }
    if (p.STREN == 0.0 && p.YSLOPE != 0.0) {
      return YSLOPE +
             " is the slope at high pressure of the nonlinear surface, which needs STREN (now 0); "
             "set "
             "STREN, or YSLOPE = 0 for linear Drucker-Prager.";
    }
    if (p.FSLOPE != 0.0 && p.STREN != 0.0 && !(p.FSLOPE > p.YSLOPE)) {
      return YSLOPE + " is not below " + FSLOPE +
             " (the limit surface would open backwards); swap them?";
    }
    if (p.FSLOPE != 0.0 && p.STREN != 0.0 && !(p.STREN > p.YSLOPE * p.PEAKI1)) {
      return STREN + " must exceed YSLOPE*PEAKI1 = " + shown(p.YSLOPE * p.PEAKI1) +
             " (the limit surface would open backwards); raise STREN or lower YSLOPE.";
    }
    return {};
  }

  /// The parameter that scatters from piece to piece, x at the vertex [stress], and by which factor
  /// it may grow.
  static double peak(const Parameters& p) { return p.PEAKI1; }
  static double largest_factor(const Parameters& p) {
    constexpr double margin = 0.99;  // of STREN > YSLOPE PEAKI1
    if (!(p.STREN > 0.0 && p.YSLOPE * p.PEAKI1 > 0.0)) return HUGE_VAL;
    return std::fmax(1.0, margin * p.STREN / (p.YSLOPE * p.PEAKI1));
  }

  /// The limit of one point or several; whether it is straight is the same for all points.
  template <class R>
  struct Of {
    R a1{}, a2{}, a3{}, a4{};
    R peak{};      ///< from which the cap's branch point is measured [stress]
    R vertex{};    ///< P, largest admissible x; +infinity for von Mises [stress]
    R steepest{};  ///< largest -dFf/dx, at the vertex: FSLOPE
    bool straight = true;

    template <class X>
    BARRENO_FUNCTION LimitOf<X> limit_at(const X& x) const {
      LimitOf<X> l;
      l.curved = straight ? X{} : X(a3 * real::exp(X(a2 * x)));
      l.value = a1 - l.curved - a4 * x;
      l.slope = -a2 * l.curved - a4;
      return l;
    }
    /// d2Ff/dx2 [1/stress].
    template <class X>
    BARRENO_FUNCTION X curvature(const X& curved) const {
      return -(a2 * a2) * curved;
    }
    /// A bound below Ff for x <= 0 that spares the exponential: exp(y) <= 1/(1 - y + y^2/2) for y
    /// <= 0.
    template <class X>
    BARRENO_FUNCTION X lower_bound(const X& x) const {
      const X y = a2 * x;
      return a1 - a3 / (1.0 - y + 0.5 * y * y) - a4 * x;
    }
    /// Gamma times as strong at the same pressure.
    BARRENO_FUNCTION void scale(const R& gamma) {
      a1 = gamma * a1;
      a3 = gamma * a3;
      a4 = gamma * a4;
      steepest = gamma * steepest;
    }
  };

  /// @param peak  PEAKI1 of the points
  template <class R>
  BARRENO_FUNCTION static Of<R> make(const Parameters& p, const R& peak) {
    Of<R> s;
    s.peak = s.vertex = peak;
    s.steepest = R{} + p.FSLOPE;
    s.straight = p.STREN == 0.0 || p.FSLOPE == 0.0;
    if (p.STREN == 0.0) {
      s.a1 = peak * p.FSLOPE;
      s.a4 = R{} + p.FSLOPE;
    } else if (p.FSLOPE == 0.0) {
      // No vertex: P = 0 would forbid tension.
      s.a1 = R{} + p.STREN;
      s.vertex = R{} + std::numeric_limits<double>::infinity();
    } else {
      const R room = p.STREN - p.YSLOPE * peak;
      s.a1 = R{} + p.STREN;
      s.a2 = (p.FSLOPE - p.YSLOPE) / room;
      s.a3 = room * real::exp(R(-s.a2 * peak));
      s.a4 = R{} + p.YSLOPE;
    }
    return s;
  }
  /// The limit of one point at every point, and that of one lane.
  template <class R>
  BARRENO_FUNCTION static Of<R> same(const Of<double>& one) {
    return {
        R{} + one.a1,
        R{} + one.a2,
        R{} + one.a3,
        R{} + one.a4,
        R{} + one.peak,
        R{} + one.vertex,
        R{} + one.steepest,
        one.straight};
  }
  template <class R>
  static Of<double> lane(const Of<R>& s, int i) {
    return {s.a1[i], s.a2[i], s.a3[i], s.a4[i], s.peak[i], s.vertex[i], s.steepest[i], s.straight};
  }
};

}  // namespace barreno::arenisca
