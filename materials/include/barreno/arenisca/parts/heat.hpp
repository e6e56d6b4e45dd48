// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/real.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Heat of rock. Plastic work and artificial viscosity heat it, T = T0 + q/c. Heated grains expand
/// by the volume strain (an eigenstrain: the law sees the strain without it)
///
///   de_T = Gamma rho_s dq/K_s,   K_s = B0 + B1 + B' p,   of wet rock Matrix bulk modulus + B' p
///
/// which open pores and the cap take up. Closed ones do not: with K = K_s the pressure rises by
/// Gamma rho_s dq, the thermal pressure of Mie and Grueneisen with a constant Gamma rho. The work
/// p de_T of the expansion is taken from the heat. Hot rock is weaker,
///
///   Ff(T) = Ff (1 - (T - T0)/(T_m - T0)),
///
/// at least a thousandth of Ff; the vertex stays.
struct Heat {
  struct Parameters {
    double specific_heat, grueneisen, grain_density, initial_temperature, melting_temperature;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::specific_heat,
             "Specific heat",
             d::heat_capacity,
             at_least(0.0),
             0.0,
             "c: heat capacity. 0: rock without heat, as published"
         ),
         optional(
             &P::grueneisen,
             "Grueneisen parameter",
             d::none,
             at_least(0.0),
             0.0,
             "Gamma of the grains: heated grains expand. 0: they do not"
         ),
         optional(
             &P::grain_density,
             "Grain density",
             d::density,
             at_least(0.0),
             0.0,
             "rho_s of the grains at no pressure, needed with a Grueneisen parameter"
         ),
         optional(
             &P::initial_temperature,
             "Initial temperature",
             d::temperature,
             above(0.0),
             293.0,
             "T0: temperature before the start"
         ),
         optional(
             &P::melting_temperature,
             "Melting temperature",
             d::temperature,
             at_least(0.0),
             0.0,
             "T_m: rock loses its shear strength on the way to it. 0: strength without heat"
         )},
        {}};
  }
  static std::string check(const Parameters& p) {
    if (p.specific_heat == 0.0) {
      if (p.grueneisen > 0.0 || p.melting_temperature > 0.0 || p.grain_density > 0.0) {
        const std::string name = p.grueneisen > 0.0 ? named("Grueneisen parameter", p.grueneisen)
                                 : p.grain_density > 0.0
                                     ? named("Grain density", p.grain_density)
                                     : named("Melting temperature", p.melting_temperature);
        return name +
               " needs a Specific heat, but that is 0 (rock without heat); set it, about 1000 "
               "J/(kg K) for sandstone under shock, or leave this out.";
      }
      return {};
    }
    if (p.grueneisen > 0.0 && p.grain_density == 0.0) {
      return named("Grueneisen parameter", p.grueneisen) +
             " needs the Grain density (the grains expand), which is 0; set it, 2650 kg/m3 for "
             "quartz.";
    }
    if (p.grain_density > 0.0 && p.grueneisen == 0.0) {
      return named("Grain density", p.grain_density) +
             " has no effect without a Grueneisen parameter (it tells how the grains expand); set "
             "that too, or leave this out.";
    }
    if (p.melting_temperature > 0.0 && !(p.melting_temperature > p.initial_temperature)) {
      return named("Melting temperature", p.melting_temperature) + " does not exceed " +
             named("Initial temperature", p.initial_temperature) +
             " (rock would be molten before the start); raise it.";
    }
    return {};
  }

  double per_specific_heat = 0.0;    ///< 1/c [temperature mass/energy]
  double per_heat_capacity = 0.0;    ///< 1/(rho c), rho of the rock [temperature/stress]
  double pressure_per_kelvin = 0.0;  ///< Gamma rho_s c [stress/temperature]
  double initial_temperature = 293.0;
  double per_way_to_melting = 0.0;  ///< 1/(T_m - T0) [1/temperature]; 0: strength without heat
  double grains = 1.0;              ///< K_s at no pressure [stress]
  double stiffening = 0.0;          ///< B'

  /// @param p        of heat, elasticity and fluid
  /// @param density  of the rock, pores and all
  template <class All>
  static Heat make(const All& p, double density) {
    Heat h;
    h.initial_temperature = p.initial_temperature;
    if (p.specific_heat == 0.0) return h;  // rock without heat that has other features
    h.per_specific_heat = 1.0 / p.specific_heat;
    h.per_heat_capacity = 1.0 / (density * p.specific_heat);
    h.pressure_per_kelvin = p.grueneisen * p.grain_density * p.specific_heat;
    if (p.melting_temperature > 0.0)
      h.per_way_to_melting = 1.0 / (p.melting_temperature - p.initial_temperature);
    const bool own_grains = p.fluid_B0 > 0.0 && p.matrix_bulk_modulus > 0.0;
    h.grains = own_grains ? p.matrix_bulk_modulus : p.B0 + p.B1;
    h.stiffening = p.grain_stiffening;
    return h;
  }
  /// Strength at a temperature over that at T0.
  template <class R>
  BARRENO_FUNCTION R softened(const R& temperature) const {
    constexpr double least = 1e-3;
    const R way = (temperature - initial_temperature) * per_way_to_melting;
    return real::smaller(real::larger(R(1.0 - way), least), 1.0);
  }
  /// Volume strain of grains that get hotter, under a mean pressure. What round-off
  /// makes of rock at rest is nothing.
  template <class R>
  BARRENO_FUNCTION R expansion(const R& warming, const R& pressure) const {
    constexpr double nothing = 1e-25;
    const R strain =
        warming * pressure_per_kelvin / (grains + stiffening * real::larger(pressure, 0.0));
    return real::select(real::abs(strain) > nothing, strain, 0.0);
  }
};

}  // namespace barreno::arenisca
