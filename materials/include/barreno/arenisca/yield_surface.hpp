// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>
#include <limits>

namespace barreno::arenisca {

/// Counts yield-function evaluations for benchmarks; the default counts nothing and costs nothing.
/// Every counter also hears of the substeps that were taken (frozen_substeps.hpp).
struct NoCounter {
  BARRENO_FUNCTION void add() {}
  BARRENO_FUNCTION void took(double /*fraction*/) {}
};
struct EvaluationCounter {
  long evaluations = 0;
  BARRENO_FUNCTION void add() { ++evaluations; }
  BARRENO_FUNCTION void took(double /*fraction*/) {}
};

/// Cap of the surface: hydrostatic strength X and branch point kappa [stress]; absent when not
/// `present`.
struct Cap {
  bool present = false;
  double X = 0.0, kappa = 0.0;
};

/// Point of the meridian at I1 = x: limit function, its slope and the cap's factor squared.
struct MeridianPoint {
  double limit;        ///< Ff(x) [stress]
  double cap_squared;  ///< fc^2; negative beyond the cap's tip, 1 outside the cap's range
  double slope;        ///< fc d(Ff fc)/dx, finite everywhere, also at the cap's tip
};

/// Meridian of the yield surface in x = I1 (minus the elastic centre, which is 0 drained) and q =
/// sqrt(J2).
///
///   q = Ff(x) fc(x),  Ff = a1 - a3 exp(a2 x) - a4 x,  fc^2 = 1 - ((kappa - x)/(kappa - X))^2 for x
///   < kappa
///
/// It is convex: Ff is concave and falls, fc is concave and rises, so is their product.
struct YieldSurface {
  double a1 = 0.0, a2 = 0.0, a3 = 0.0, a4 = 0.0;
  double peak = 0.0;      ///< PEAKI1, from which the cap's branch point is measured [stress]
  double vertex = 0.0;    ///< P, largest admissible x; +infinity for von Mises [stress]
  double CR = 0.0;        ///< shape of the cap
  double steepest = 0.0;  ///< largest -dFf/dx, at the vertex: FSLOPE

  BARRENO_FUNCTION bool linear() const { return a3 == 0.0; }
  BARRENO_FUNCTION double limit(double x) const {
    return linear() ? a1 - a4 * x : a1 - a3 * std::exp(a2 * x) - a4 * x;
  }
  BARRENO_FUNCTION Cap cap_at(double X) const { return {true, X, peak - CR * (peak - X)}; }

  template <class Counter>
  BARRENO_FUNCTION MeridianPoint at(double x, const Cap& cap, Counter& count) const {
    count.add();
    const double curved = linear() ? 0.0 : a3 * std::exp(a2 * x);
    const double limit_x = a1 - curved - a4 * x;
    const double limit_slope = -a2 * curved - a4;
    if (!cap.present || x >= cap.kappa) return {limit_x, 1.0, limit_slope};
    const double length = cap.kappa - cap.X;
    // 1 - c^2 as a product: no cancellation at the tip, where 1 - c is small.
    const double one_minus_c = (x - cap.X) / length;
    const double c = (cap.kappa - x) / length;
    const double cap_squared = one_minus_c * (1.0 + c);
    return {limit_x, cap_squared, limit_slope * cap_squared + limit_x * c / length};
  }

  /// Elastic if X <= x <= P and J2 <= (Ff fc)^2.
  template <class Counter>
  BARRENO_FUNCTION bool contains(double x, double J2, const Cap& cap, Counter& count) const {
    if (x > vertex || (cap.present && x < cap.X)) return false;
    double cap_squared = 1.0;
    if (cap.present && x < cap.kappa) {
      const double c = (cap.kappa - x) / (cap.kappa - cap.X);
      cap_squared = 1.0 - c * c;
    }
    // exp(y) <= 1/(1 - y + y^2/2) for y <= 0: a bound that spares the exponential for most elastic
    // points.
    const double y = a2 * x;
    const double bound = a1 - a3 / (1.0 - y + 0.5 * y * y) - a4 * x;
    if (x <= 0.0 && bound > 0.0 && J2 <= bound * bound * cap_squared) return true;
    count.add();
    const double limit_x = limit(x);
    return limit_x >= 0.0 && J2 <= limit_x * limit_x * cap_squared;
  }
};

/// Coefficients of the limit surface from PEAKI1, FSLOPE, STREN and YSLOPE; the cases that check()
/// admits: linear Drucker-Prager (STREN = YSLOPE = 0), von Mises (STREN only), nonlinear
/// Drucker-Prager (else; with PEAKI1 = YSLOPE = 0 it is the "zero vertex to von Mises" surface).
BARRENO_FUNCTION YieldSurface
make_yield_surface(double peak, double FSLOPE, double STREN, double YSLOPE, double CR) {
  YieldSurface s;
  s.peak = s.vertex = peak;
  s.CR = CR;
  s.steepest = FSLOPE;
  if (STREN == 0.0) {
    s.a1 = peak * FSLOPE;
    s.a4 = FSLOPE;
  } else if (FSLOPE == 0.0) {
    // No vertex: P = 0 would forbid tension.
    s.a1 = STREN;
    s.vertex = std::numeric_limits<double>::infinity();
  } else {
    s.a1 = STREN;
    s.a2 = (FSLOPE - YSLOPE) / (STREN - YSLOPE * peak);
    s.a3 = (STREN - YSLOPE * peak) * std::exp(-s.a2 * peak);
    s.a4 = YSLOPE;
  }
  return s;
}

}  // namespace barreno::arenisca
