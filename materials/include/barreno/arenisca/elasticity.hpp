// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Tangent bulk and shear modulus at a state [stress].
struct Moduli {
  double bulk, shear;
};

/// Nonlinear isotropic elasticity of the drained rock, I1 = tr(sigma), tension positive.
///
///   I1 >= 0 or evp > 0:    K = B0, G = G0
///   I1 < 0 and evp <= 0:   K = B0 + B1 exp(B2/I1) - B3 exp(B4/evp)   (last term for evp < 0)
///                          nu = G1 + G2 exp(B2/I1), G = 1.5 K (1 - 2 nu)/(1 + nu)   if G1 and G2
///                          are both set
///
/// Dilated rock (evp > 0) keeps the low-pressure moduli until it is compacted again. The published
/// benchmark 08 depends on it (I1 = -1481 with it, -1527 without, at the seventh way point).
struct Elasticity {
  double B0, B1, B2, B3, B4, G0, G1, G2;

  /// The moduli jump where rock becomes dilated; |evp| below this counts as at the jump (round-off
  /// of an isochoric flow is not dilation).
  static constexpr double at_jump = 1e-12;
  BARRENO_FUNCTION static bool dilated(double evp) { return evp > at_jump; }
  /// Plastic strain at which to take the moduli when the way to `evp_end` began at `evp_begin`: at
  /// the jump itself those of the side it came from.
  BARRENO_FUNCTION static double seen_from(double evp_begin, double evp_end) {
    return dilated(evp_begin) && std::fabs(evp_end) <= at_jump ? 2.0 * at_jump : evp_end;
  }
  /// Part of the way from one evp to the other at which the jump lies; 1 if it does not lie
  /// between.
  BARRENO_FUNCTION double way_to_jump(double evp_begin, double evp_end) const {
    const bool between =
        (evp_begin < -at_jump && evp_end > at_jump) || (evp_begin > at_jump && evp_end < -at_jump);
    if (!between || (B1 == 0.0 && B3 == 0.0 && !variable_ratio())) return 1.0;
    return evp_begin / (evp_begin - evp_end);
  }

  BARRENO_FUNCTION bool variable_ratio() const { return G1 != 0.0 && G2 != 0.0; }

  /// exp(B2/I1) and its two derivatives by I1: all pressure dependence enters through this one
  /// number, so a second-order step needs one exponential only.
  struct PressureTerm {
    double value, slope, curvature;
  };
  BARRENO_FUNCTION PressureTerm pressure_term(double I1, double evp) const {
    if (I1 >= 0.0 || dilated(evp) || (B1 == 0.0 && !variable_ratio())) return {0.0, 0.0, 0.0};
    const double inverse = 1.0 / I1, ratio = B2 * inverse;
    const double value = std::exp(ratio);
    const double slope = -ratio * inverse * value;
    return {value, slope, -slope * inverse * (ratio + 2.0)};
  }

  /// Elastic-plastic coupling B3 exp(B4/evp): crushed rock is softer than its pressure says
  /// [stress].
  BARRENO_FUNCTION double coupling(double I1, double evp) const {
    if (B3 == 0.0 || I1 >= 0.0 || evp >= 0.0) return 0.0;
    return B3 * std::exp(B4 / evp);
  }

  BARRENO_FUNCTION Moduli moduli(double pressure_value, double coupling_value) const {
    const double bulk = B0 + B1 * pressure_value - coupling_value;
    if (!variable_ratio()) return {bulk, G0};
    return {bulk, shear_from_ratio(bulk, G1 + G2 * pressure_value)};
  }
  BARRENO_FUNCTION Moduli moduli_at(double I1, double evp) const {
    return moduli(pressure_term(I1, evp).value, coupling(I1, evp));
  }

  BARRENO_FUNCTION static double shear_from_ratio(double bulk, double nu) {
    return 1.5 * bulk * (1.0 - 2.0 * nu) / (1.0 + nu);
  }

  /// Upper bounds over all reachable states, for the first time step.
  BARRENO_FUNCTION Moduli upper_bound() const {
    const double bulk = B0 + B1;
    if (!variable_ratio()) return {bulk, G0};
    const double smallest_ratio = G2 < 0.0 ? G1 + G2 : G1;
    return {bulk, std::fmax(G0, shear_from_ratio(bulk, smallest_ratio))};
  }
};

}  // namespace barreno::arenisca
