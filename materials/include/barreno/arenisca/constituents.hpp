// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/selection.hpp"
#include "barreno/real.hpp"

namespace barreno::arenisca {

/// What fills a volume of saturated rock, grains and fluid: their bulk moduli and, under the
/// pressures of a jet, how their volumes follow the pressure (docs/method.md, 10.6 and 10.7):
///
///   volume = exp(-F(p)),   F = ln(1 + B' p/Km)/B' + D w^2 (3 - 2 w),   w as in
///   parts/elasticity.hpp volume = exp(-F_f(p)), F_f = ln(1 + n p/Kf)/n
///
/// Moduli at no pressure that do not change keep the formulas, and the bits, of constant moduli.
struct Constituents {
  double matrix = 0.0;  ///< Km, of the grains [stress]
  double fluid = 0.0;   ///< Kf [stress]
  double per_matrix = 0.0, per_fluid = 0.0;
  double grain_stiffening = 0.0, fluid_stiffening = 0.0;  ///< B', n
  double transition_strain = 0.0;                         ///< D; 0: no transition
  double transition_start = 0.0, per_transition = 0.0;    ///< p_s, 1/(p_e - p_s)
  bool change = false;  ///< whether a modulus depends on the pressure

  /// @param p  of the fluid and of the elasticity
  template <class All>
  static Constituents make(const All& p) {
    const double matrix = p.matrix_bulk_modulus > 0.0 ? p.matrix_bulk_modulus : p.B0 + p.B1;
    Constituents c{matrix, p.fluid_B0, 1.0 / matrix, 1.0 / p.fluid_B0};
    c.grain_stiffening = p.grain_stiffening;
    c.fluid_stiffening = p.fluid_stiffening;
    c.change = c.grain_stiffening != 0.0 || c.fluid_stiffening != 0.0;
    if (p.transition_strain == 0.0) return c;
    c.change = true;
    c.transition_strain = p.transition_strain;
    c.transition_start = p.transition_start;
    c.per_transition = 1.0 / (p.transition_end - p.transition_start);
    return c;
  }
  /// F of the grains: logarithm of their volume at no pressure over that at this one.
  template <class R>
  BARRENO_FUNCTION R grain_strain(const R& pressure) const {
    R strain = murnaghan_strain(pressure, per_matrix, grain_stiffening);
    if (transition_strain == 0.0) return strain;
    const R w = way(pressure);
    return strain + transition_strain * (w * w * (3.0 - 2.0 * w));
  }
  /// dF/dp of the grains, 1/Km at this pressure [1/stress].
  template <class R>
  BARRENO_FUNCTION R grain_compliance(const R& pressure) const {
    R compliance = 1.0 / (matrix + grain_stiffening * real::larger(pressure, 0.0));
    if (transition_strain == 0.0) return compliance;
    const R w = way(pressure);
    return compliance + (6.0 * transition_strain * per_transition) * (w * (1.0 - w));
  }
  /// Rise of F between two pressures.
  BARRENO_FUNCTION double grain_strain_between(double from, double to) const {
    return change ? grain_strain(to) - grain_strain(from) : (to - from) * per_matrix;
  }
  BARRENO_FUNCTION double fluid_strain_between(double from, double to) const {
    return change ? fluid_strain(to) - fluid_strain(from) : (to - from) * per_fluid;
  }
  /// Work of a pressure on grains alone between two pressures, the integral of p dF: Simpson's
  /// rule.
  BARRENO_FUNCTION double work_on_grains(double from, double to) const {
    if (!change) return 0.5 * (to + from) * (to - from) * per_matrix;
    const double middle = 0.5 * (from + to);
    return (to - from) *
           (from * grain_compliance(from) + 4.0 * middle * grain_compliance(middle) +
            to * grain_compliance(to)) /
           6.0;
  }
  template <class R>
  BARRENO_FUNCTION R fluid_strain(const R& pressure) const {
    return murnaghan_strain(pressure, per_fluid, fluid_stiffening);
  }
  /// 1/Kf at this pressure [1/stress].
  template <class R>
  BARRENO_FUNCTION R fluid_compliance(const R& pressure) const {
    if (fluid_stiffening == 0.0) return R{} + per_fluid;
    return 1.0 / (fluid + fluid_stiffening * real::larger(pressure, 0.0));
  }

private:
  /// Part of the transition that a pressure has completed, before it is made smooth.
  template <class R>
  BARRENO_FUNCTION R way(const R& pressure) const {
    const R w = (pressure - transition_start) * per_transition;
    return real::smaller(real::larger(w, 0.0), 1.0);
  }
  /// Below no pressure the modulus is that at no pressure.
  template <class R>
  BARRENO_FUNCTION static R murnaghan_strain(
      const R& pressure, double per_modulus, double stiffening
  ) {
    const R first = pressure * per_modulus;
    if (stiffening == 0.0) return first;
    const R pressed = real::larger(first, 0.0);
    return real::smaller(first, 0.0) + real::log(R(1.0 + stiffening * pressed)) / stiffening;
  }
};

}  // namespace barreno::arenisca
