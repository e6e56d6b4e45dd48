// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/pore_fluid.hpp"
#include "barreno/portability.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Undrained elastic way from the elastic centre to x = I1 - zeta.
struct CentrePath {
  double strain;    ///< volume strain of it, the integral of dx/(3 K)
  double pressure;  ///< of the fluid at its end: p_c less the integral of B dx/3 [stress]
};

/// d strain/dx and -d pressure/dx where the fluid works: 1/(3 Ks) and B/3.
BARRENO_FUNCTION CentrePath slope_of_path(const PoreFluid& fluid, double drained, double phi) {
  const double alpha = 1.0 - drained / fluid.matrix;
  if (alpha <= 0.0) return {1.0 / (3.0 * drained), 0.0};
  const double storage = alpha / fluid.matrix + phi * (1.0 / fluid.bulk - 1.0 / fluid.matrix);
  const double divisor = 3.0 * (drained * storage + alpha * alpha);
  return {storage / divisor, alpha / divisor};
}

/// Integrals of the slopes over x from `from` (not positive) to `to` below it; with moduli of the
/// drained rock if phi is negative. Panels of Gauss' rule that halve towards 0 follow exp(B2/x):
/// 1e-9 of the strain, 1e-8 of the pressure.
BARRENO_FUNCTION CentrePath integrate_path(
    const PoreFluid& fluid,
    const Elasticity& elasticity,
    double phi,
    double from,
    double to,
    double e
) {
  constexpr int points = 5;
  constexpr double place[points] = {
      0.0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640, 0.9061798459386640};
  constexpr double weight[points] = {
      0.5688888888888889,
      0.4786286704993665,
      0.4786286704993665,
      0.2369268850561891,
      0.2369268850561891};
  constexpr double negligible = 1.0 / 25.0;  // nearer to 0 than this part of B2 exp(B2/x) is none
  const bool constant = elasticity.B1 == 0.0 || elasticity.B2 == 0.0 || elasticity.dilated(e);
  const auto slope = [&](double x) {
    const double drained = elasticity.moduli_at(x, e).bulk;
    return phi < 0.0 ? CentrePath{1.0 / (3.0 * drained), 0.0} : slope_of_path(fluid, drained, phi);
  };
  CentrePath sum{0.0, 0.0};
  constexpr int max_panels = 60;
  double far = to;
  for (int panel = 1; far < from; ++panel) {
    const bool last = constant || far >= -negligible * elasticity.B2 || panel == max_panels;
    const double near = last ? from : smaller(from, 0.5 * far);
    const double middle = 0.5 * (far + near), half = 0.5 * (far - near);
    for (int i = 0; i < points; ++i) {
      const CentrePath s = slope(middle + half * place[i]);
      const double w = last ? 2.0 : weight[i];
      sum.strain += w * half * s.strain;
      sum.pressure += w * half * s.pressure;
      if (last) break;
    }
    far = near;
  }
  return sum;
}

/// The way to x from a centre in this state, e. The fluid works below at.threshold; drained beyond.
BARRENO_FUNCTION CentrePath centre_path(
    const PoreFluid& fluid, const Elasticity& elasticity, const FluidState& at, double x, double e
) {
  constexpr double drained = -1.0;
  if (x <= 0.0) {
    const double engaged = at.gap ? larger(x, at.threshold) : 0.0;
    CentrePath path = integrate_path(fluid, elasticity, drained, 0.0, engaged, e);
    const CentrePath rest = integrate_path(fluid, elasticity, at.porosity, engaged, x, e);
    path.strain += rest.strain;
    path.pressure = larger(0.0, at.pressure - rest.pressure);
    return path;
  }
  // Tension about the centre: the moduli are constant.
  const double bulk = elasticity.moduli_at(x, e).bulk;
  if (at.gap) return {x / (3.0 * bulk), 0.0};
  const CentrePath s = slope_of_path(fluid, bulk, at.porosity);
  const double part = smaller(x, at.threshold);
  return {
      s.strain * part + (x - part) / (3.0 * bulk), larger(0.0, at.pressure - s.pressure * part)};
}

/// x at the end of a way with this strain: Newton's method, bisection where that leaves the
/// bracket.
/// @param guess  where to begin [stress]
BARRENO_FUNCTION double end_of_path(
    const PoreFluid& fluid,
    const Elasticity& elasticity,
    const FluidState& at,
    double strain,
    double guess,
    double e
) {
  constexpr int max_iterations = 100;
  constexpr double round_off = 4e-16;
  double x = guess, below = -HUGE_VAL, above = HUGE_VAL;
  for (int i = 0; i < max_iterations; ++i) {
    const double residual = centre_path(fluid, elasticity, at, x, e).strain - strain;
    if (residual == 0.0) return x;
    (residual > 0.0 ? above : below) = x;
    const double bulk = saturated_moduli(fluid, elasticity, at, x, e).bulk;
    double next = x - 3.0 * bulk * residual;
    if (!(next > below && next < above)) {
      if (!std::isfinite(below) || !std::isfinite(above)) return next;
      next = 0.5 * (below + above);
    }
    const double step = std::fabs(next - x);
    x = next;
    if (step <= round_off * std::fabs(x)) break;
  }
  return x;
}

}  // namespace barreno::arenisca
