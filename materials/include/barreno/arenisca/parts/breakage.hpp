// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/real.hpp"

#include <limits>

namespace barreno::arenisca {

/// Breakage of grains, from 0 (whole) to 1 (the finest that crushing makes), after I. Einav (J.
/// Mech. Phys. Solids 55 (2007) 1274). It grows with the plastic work of crushing and of shear
/// under pressure, per volume of the rock at the start:
///
///   dB = (1 - B) dW/W_b,   dW = p max(-de_v, 0) + w(p) s : de_p,   w = p^2/(p^2 + p_B^2)
///
/// with e_v, e_p the plastic volume strain and deviator and p = max(-I1/3, 0), effective in wet
/// rock. The energy that grains store, and that breaks them, grows with p^2; shear at low pressure
/// opens cracks and rolls grains. B = 1 - exp(-W/W_b) whatever the steps and the rate. The stress
/// does not depend on it.
struct Breakage {
  struct Parameters {
    double breakage_energy, breakage_pressure;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::breakage_energy,
             "Breakage energy",
             d::stress,
             at_least(0.0),
             0.0,
             "W_b: plastic work per volume after which 1/e of the way to fully broken grains is "
             "left. 0: grains stay whole, as published"
         ),
         optional(
             &P::breakage_pressure,
             "Breakage pressure",
             d::stress,
             at_least(0.0),
             0.0,
             "p_B: (effective) mean pressure at which half of the plastic work of shear breaks "
             "grains. 0: all of it under any pressure"
         )},
        {}};
  }
  static std::string check(const Parameters& p) {
    if (p.breakage_energy > 0.0 || p.breakage_pressure == 0.0) return {};
    return named("Breakage pressure", p.breakage_pressure) +
           " needs a Breakage energy, but that is 0 (grains stay whole); set it, about 1e8 J/m3 "
           "for sandstone, or leave the pressure out.";
  }

  double per_energy = 0.0;  ///< 1/W_b [1/stress]; 0: grains stay whole
  double square = 1.0;      ///< p_B^2 [stress^2]

  template <class All>
  static Breakage make(const All& p) {
    Breakage b;
    if (p.breakage_energy > 0.0) b.per_energy = 1.0 / p.breakage_energy;
    // Above 0, so that no pressure gives no weight.
    const double square = p.breakage_pressure * p.breakage_pressure;
    b.square = square > 0.0 ? square : std::numeric_limits<double>::min();
    return b;
  }
  /// The part of a plastic work that breaks grains [stress].
  /// @param x       mean I1 of the substep
  /// @param opened  plastic volume strain of the substep
  /// @param shear   plastic work of its shear stress
  template <class R>
  BARRENO_FUNCTION R work(const R& x, const R& opened, const R& shear) const {
    const R pressure = real::larger(R(x * (-1.0 / 3.0)), 0.0);
    const R stored = pressure * pressure;
    return pressure * real::larger(R(0.0 - opened), 0.0) +
           stored / (stored + square) * real::larger(shear, 0.0);
  }
  /// Breakage after a work that breaks grains.
  template <class R>
  BARRENO_FUNCTION R after(const R& breakage, const R& work) const {
    const R whole = real::smaller(real::exp(R(-per_energy * work)), 1.0);
    return real::smaller(R(breakage + (1.0 - breakage) * (1.0 - whole)), 1.0);
  }
};

}  // namespace barreno::arenisca
