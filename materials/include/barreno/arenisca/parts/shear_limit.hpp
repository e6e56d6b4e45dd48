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
///
/// A card may let the strength tend to a limit M. The part that grows with pressure without end, a4
/// y with y = PEAKI1 - x, then bends as in the law of N. Lundborg (Strength of rock-like materials,
/// Int. J. Rock Mech. Min. Sci. 5 (1968) 427):
///
///   Ff = S - a3 exp(a2 x) + a4 y/(1 + a4 y/(M - S)),   S = a1 - a4 PEAKI1
///
/// Vertex and slope there are those without limit; S = 0 (linear Drucker-Prager) is Lundborg's law.
struct ShearLimit {
  struct Parameters {
    double PEAKI1, FSLOPE, STREN, YSLOPE, strength_limit;
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
         optional(&P::YSLOPE, "YSLOPE", d::none, at_least(0.0), 0.0, "slope at high pressure"),
         optional(
             &P::strength_limit,
             "Strength limit",
             d::stress,
             at_least(0.0),
             0.0,
             "M: shear strength sqrt(J2) that no pressure exceeds. 0: none, as published"
         )},
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
    return p.strength_limit > 0.0 ? check_strength_limit(p) : std::string{};
  }
  static std::string check_strength_limit(const Parameters& p) {
    const std::string limit = named("Strength limit", p.strength_limit);
    if (p.STREN > 0.0 && p.YSLOPE == 0.0) {
      return limit +
             " has no effect with YSLOPE = 0 (no pressure exceeds STREN = " + shown(p.STREN) +
             " then); leave the limit out, or set YSLOPE.";
    }
    if (p.STREN > 0.0 && !(p.strength_limit > p.STREN)) {
      return limit + " does not exceed " + named("STREN", p.STREN) +
             " (rock has this strength before it reaches the limit); raise the limit or lower "
             "STREN.";
    }
    const double cohesion = p.FSLOPE * p.PEAKI1;
    if (!(p.strength_limit > cohesion)) {
      return limit + " does not exceed the cohesion FSLOPE*PEAKI1 = " + shown(cohesion) +
             ", the strength without pressure; raise the limit.";
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
    R peak{};              ///< from which the cap's branch point is measured [stress]
    R vertex{};            ///< P, largest admissible x; +infinity for von Mises [stress]
    R steepest{};          ///< largest -dFf/dx, at the vertex: FSLOPE
    bool straight = true;  ///< no exponential
    bool limited = false;  ///< a1 is S and the strength tends to M
    R per_strength{};      ///< a4/(M - S) [1/stress]
    R bend{};              ///< of the curvature: a2^2, or 1 where a2 = 0
    R curl{};              ///< 2 a4/(M - S)/bend

    template <class X>
    BARRENO_FUNCTION LimitOf<X> limit_at(const X& x) const {
      LimitOf<X> l;
      l.curved = straight ? X{} : X(a3 * real::exp(X(a2 * x)));
      if (limited) {
        bend_limit(x, l);
        return l;
      }
      l.value = a1 - l.curved - a4 * x;
      l.slope = -a2 * l.curved - a4;
      return l;
    }
    /// The same where the strength tends to a limit. Beyond the vertex, where trial states may lie,
    /// the hyperbola would come to its pole; its tangent goes on instead.
    /// @param[in,out] l  with the exponential as `curved`
    template <class X>
    BARRENO_FUNCTION void bend_limit(const X& x, LimitOf<X>& l) const {
      const X part = part_at(x), least = a4 * part, fall = least * part;
      l.value = a1 - l.curved + least * (peak - x);
      l.slope = -a2 * l.curved - fall;
      l.curved = l.curved + real::select(x < peak, curl * part * fall, 0.0);
    }
    /// What the limit leaves of a4 y: 1/(1 + a4 y/(M - S)), and all beyond the vertex.
    template <class X>
    BARRENO_FUNCTION X part_at(const X& x) const {
      return 1.0 / (1.0 + per_strength * real::larger(X(peak - x), 0.0));
    }
    /// d2Ff/dx2 [1/stress].
    template <class X>
    BARRENO_FUNCTION X curvature(const X& curved) const {
      return -bend * curved;
    }
    /// A bound below Ff for x <= 0 that spares the exponential: exp(y) <= 1/(1 - y + y^2/2) for y
    /// <= 0.
    template <class X>
    BARRENO_FUNCTION X lower_bound(const X& x) const {
      const X y = a2 * x;
      const X curved = a3 / (1.0 - y + 0.5 * y * y);
      // 1/(1 + z) >= 1 - z.
      if (limited) return a1 - curved + a4 * (peak - x) * (1.0 - per_strength * (peak - x));
      return a1 - curved - a4 * x;
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
    return make(p, peak, R(R{} + p.FSLOPE));
  }
  /// @param slope  at the vertex, instead of FSLOPE
  template <class R>
  BARRENO_FUNCTION static Of<R> make(const Parameters& p, const R& peak, const R& slope) {
    Of<R> s;
    s.peak = s.vertex = peak;
    s.steepest = slope;
    s.straight = p.STREN == 0.0 || p.FSLOPE == 0.0;
    if (p.STREN == 0.0) {
      s.a1 = peak * slope;
      s.a4 = slope;
    } else if (p.FSLOPE == 0.0) {
      // No vertex: P = 0 would forbid tension.
      s.a1 = R{} + p.STREN;
      s.vertex = R{} + std::numeric_limits<double>::infinity();
    } else {
      const R room = p.STREN - p.YSLOPE * peak;
      s.a1 = R{} + p.STREN;
      s.a2 = (slope - p.YSLOPE) / room;
      s.a3 = room * real::exp(R(-s.a2 * peak));
      s.a4 = R{} + p.YSLOPE;
    }
    s.bend = s.a2 * s.a2;
    if (p.strength_limit > 0.0) bend_to(p.strength_limit, s);
    return s;
  }
  /// @param[in,out] s  without limit; the vertex is finite
  template <class R>
  BARRENO_FUNCTION static void bend_to(double strength, Of<R>& s) {
    s.limited = true;
    s.a1 = s.straight ? R{} : R(s.a1 - s.a4 * s.peak);
    s.per_strength = s.a4 / (strength - s.a1);
    if (s.straight) s.bend = R{} + 1.0;
    s.curl = 2.0 * s.per_strength / s.bend;
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
        one.straight,
        one.limited,
        R{} + one.per_strength,
        R{} + one.bend,
        R{} + one.curl};
  }
  template <class R>
  static Of<double> lane(const Of<R>& s, int i) {
    return {
        s.a1[i],
        s.a2[i],
        s.a3[i],
        s.a4[i],
        s.peak[i],
        s.vertex[i],
        s.steepest[i],
        s.straight,
        s.limited,
        s.per_strength[i],
        s.bend[i],
        s.curl[i]};
  }
};

}  // namespace barreno::arenisca
