// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/root_finding.hpp"
#include "barreno/portability.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Fluid in the pores. The elastic centre is the state of zero effective stress; there the fluid is
/// under p_c and the volumetric strain is e:
///
///   exp(e) = (1 - phi_i) exp(-(p_c - p_i)/Km) + mu phi_i exp(-(p_c - p_i)/Kf),   p_c >= 0
///
/// with mu the mass of fluid over its initial mass. Where the pores are larger than the fluid there
/// is a gas gap and p_c = 0; the fluid engages again when elastic compression has closed the gap.
///
/// Where fluid has flowed, e counts from the elastic centre of virgin rock with as much fluid:
/// the expansion of grains whose pressure drops is not dilation of the rock. See holding().
struct PoreFluid {
  double bulk = 0.0;              ///< Kf, 0: no fluid [stress]
  double matrix = 0.0;            ///< Km, bulk modulus of the grains [stress]
  double initial_pressure = 0.0;  ///< p_i [stress]
  double porosity = 0.0;          ///< phi_i

  BARRENO_FUNCTION bool present() const { return bulk > 0.0; }

  /// Virgin rock with some mass of fluid: the pressure at its elastic centre, which is at e = 0,
  /// and mu, 1 where the pores are full. mass = mu density.
  struct Held {
    double pressure, mu, density;
  };
  /// Grains and pores under one pressure keep the porosity, so that
  /// ln(mass) = (pressure - p_i)(1/Kf - 1/Km).
  BARRENO_FUNCTION Held holding(double mass) const {
    if (mass == 1.0 || !present()) return {initial_pressure, mass, 1.0};
    const double per_pressure = 1.0 / bulk - 1.0 / matrix;
    const double pressure =
        mass > 0.0 ? initial_pressure + std::log(mass) / per_pressure : -HUGE_VAL;
    if (pressure >= 0.0) return {pressure, 1.0, mass};
    const double full = std::exp(-initial_pressure * per_pressure);
    return {0.0, mass / full, full};
  }

  /// e at which the fluid just fills the pores without pressure.
  BARRENO_FUNCTION double filling_strain(double mu) const {
    return std::log(
        (1.0 - porosity) * std::exp(initial_pressure / matrix) +
        mu * porosity * std::exp(initial_pressure / bulk)
    );
  }

  /// p_c(e) [stress]. The logarithm of the sum falls with p_c and is convex: Newton converges from
  /// any start.
  BARRENO_FUNCTION double centre_pressure(double e, double mu) const {
    constexpr int max_iterations = 60;
    // The next step would be below step^2/(2 Kf): beyond round-off.
    constexpr double last_but_one = 1e-9;
    const double solid = 1.0 - porosity, fluid = mu * porosity;
    if (fluid <= 0.0) return larger(0.0, initial_pressure - matrix * (e - std::log(solid)));
    double q = -e / (solid / matrix + fluid / bulk);
    // exp(-q/Kf) must not overflow; from this side Newton is monotone.
    q = larger(q, -30.0 * bulk);
    for (int i = 0; i < max_iterations; ++i) {
      const double a = solid * std::exp(-q / matrix), b = fluid * std::exp(-q / bulk);
      const double step = (std::log(a + b) - e) * (a + b) / (a / matrix + b / bulk);
      q += step;
      if (std::fabs(step) <= last_but_one * bulk) break;
    }
    return larger(0.0, initial_pressure + q);
  }

  /// Pore volume over volume at the elastic centre.
  BARRENO_FUNCTION double porosity_at(double e, double mu, double pressure) const {
    if (pressure > 0.0) {
      return mu * porosity * std::exp(-(pressure - initial_pressure) / bulk - e);
    }
    return larger(0.0, 1.0 - (1.0 - porosity) * std::exp(initial_pressure / matrix - e));
  }

  /// Biot-Gassmann: Kd + alpha^2 M, 1/M = alpha/Km + phi (1/Kf - 1/Km), alpha = 1 - Kd/Km [stress].
  BARRENO_FUNCTION double saturated(double drained, double phi) const {
    const double alpha = 1.0 - drained / matrix;
    if (alpha == 0.0) return drained;
    return drained + alpha * alpha / (alpha / matrix + phi * (1.0 / bulk - 1.0 / matrix));
  }
  /// Skempton's B = alpha M/Ks.
  BARRENO_FUNCTION double skempton(double drained, double phi) const {
    const double alpha = 1.0 - drained / matrix;
    if (alpha <= 0.0) return 0.0;
    const double storage = 1.0 / (alpha / matrix + phi * (1.0 / bulk - 1.0 / matrix));
    return alpha * storage / (drained + alpha * alpha * storage);
  }
};

/// What the fluid does at one elastic centre: found once per evaluation of a surface or a modulus.
struct FluidState {
  double pressure;   ///< p_c [stress]
  double porosity;   ///< at the centre
  double threshold;  ///< x = I1 - zeta below which the fluid carries pressure [stress]
  bool gap;          ///< true where a gas gap is left at the centre
};

/// Drained elastic volume strain from the centre to x: integral of dx/(3 Kd) by Gauss' rule of 8
/// points (1e-7 where Kd doubles between them).
BARRENO_FUNCTION double drained_strain(const Elasticity& elasticity, double x, double e) {
  constexpr double place[4] = {
      0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr double weight[4] = {
      0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double at = 0.5 * x * (1.0 + side * place[i]);
      sum += weight[i] / elasticity.moduli_at(at, e).bulk;
    }
  }
  return sum * 0.5 * x / 3.0;
}

/// x < 0 at which elastic compression has closed a gas gap: pore strain eps - x/(3 Km) = -gap.
BARRENO_FUNCTION double closing_stress(
    const PoreFluid& fluid, const Elasticity& elasticity, double e, double gap
) {
  const auto closure = [&](double x) {
    return drained_strain(elasticity, x, e) - x / (3.0 * fluid.matrix) + gap;
  };
  const double soft = elasticity.moduli_at(0.0, e).bulk;
  // Softest rock throughout closes it first.
  double above = -3.0 * gap / (1.0 / soft - 1.0 / fluid.matrix);
  if (elasticity.dilated(e)) return above;  // of constant modulus
  constexpr double farthest = 1e4;          // in matrix moduli
  double f_above = closure(above);
  if (f_above <= 0.0) return above;
  double below = 2.0 * above, f_below = closure(below);
  while (f_below > 0.0 && below > -farthest * fluid.matrix) {
    below *= 2.0;
    f_below = closure(below);
  }
  if (f_below > 0.0) return below;
  return find_root(closure, {below, f_below}, {above, f_above}, 1e-12 * std::fabs(below), 0.0);
}

/// State of the fluid at the elastic centre e.
/// @param filling  filling_strain(mu)
BARRENO_FUNCTION FluidState fluid_at(
    const PoreFluid& fluid, const Elasticity& elasticity, double e, double mu, double filling
) {
  const double gap = -std::expm1(filling - e);
  if (gap > 0.0) {
    return {0.0, fluid.porosity_at(e, mu, 0.0), closing_stress(fluid, elasticity, e, gap), true};
  }
  const double pressure = fluid.centre_pressure(e, mu);
  const double phi = fluid.porosity_at(e, mu, pressure);
  // Tension about the centre: the actual pressure p_c - B x/3 falls to zero.
  const double b = fluid.skempton(elasticity.moduli_at(0.0, e).bulk, phi);
  return {pressure, phi, b > 0.0 ? 3.0 * pressure / b : HUGE_VAL, false};
}

/// Tangent moduli of dx = 3 K (d eps - de): saturated where the fluid carries pressure.
BARRENO_FUNCTION Moduli saturated_moduli(
    const PoreFluid& fluid, const Elasticity& elasticity, const FluidState& at, double x, double e
) {
  Moduli m = elasticity.moduli_at(x, e);
  const bool engaged = (x <= 0.0 && !at.gap) || x < at.threshold;
  if (engaged) m.bulk = fluid.saturated(m.bulk, at.porosity);
  return m;
}

/// Hydrostatic strength from the centre: that of the crush curve, times Ks/Kd (both at half of it)
/// where the fluid works, so that the cap stands still during elastic loading: Biot-scaled
/// [stress]. Of dilated rock too the moduli are those of undilated rock: the strength must not jump
/// where they do (surfaces that jump make several returns possible).
BARRENO_FUNCTION double saturated_strength(
    const PoreFluid& fluid, const Elasticity& elasticity, const FluidState& at, double dry, double e
) {
  const double drained = elasticity.moduli_at(0.5 * dry, smaller(e, 0.0)).bulk;
  const double ratio = fluid.saturated(drained, at.porosity) / drained;
  if (!at.gap) return dry * ratio;
  return at.threshold <= dry ? dry : at.threshold + (dry - at.threshold) * ratio;
}

}  // namespace barreno::arenisca
