// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"

namespace barreno::arenisca {

/// What fills the pores, and by which law it acts on the rock: pores.hpp, pore_fluid.hpp (effective
/// stress about an elastic centre) or published_fluid.hpp. Its rules need the moduli of the rock
/// and stand in arenisca_rules.hpp.
struct Fluid {
  struct Parameters {
    double fluid_B0, fluid_stiffening, fluid_pressure_initial, matrix_bulk_modulus;
    int backstress_strain, undrained_moduli;

    /// Indices of words.
    static constexpr int elastic_centre = 0, plastic_backstress = 1, poroplastic = 2;
    static constexpr int arenisca3_moduli = 1;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::fluid_B0,
             "fluid_B0",
             d::stress,
             at_least(0.0),
             0.0,
             "bulk modulus of the fluid; 0: dry"
         ),
         optional(
             &P::fluid_stiffening,
             "Fluid stiffening",
             d::none,
             at_least(0.0),
             0.0,
             "n: dK/dp of the fluid, whose bulk modulus at no pressure is fluid_B0. 0: a constant "
             "modulus, for pressures far below fluid_B0"
         ),
         optional(
             &P::fluid_pressure_initial,
             "fluid_pressure_initial",
             d::stress,
             at_least(0.0),
             0.0,
             "initial pressure of the fluid"
         ),
         optional(
             &P::matrix_bulk_modulus,
             "Matrix bulk modulus",
             d::stress,
             at_least(0.0),
             0.0,
             "bulk modulus of the grains at no pressure; 0: B0 + B1"
         )},
        {{&P::backstress_strain,
          "Backstress strain",
          {"elastic centre", "plastic", "poroplastic"},
          P::poroplastic,
          "effect of the fluid on the rock; poroplastic: strength, flow and crush curve are those "
          "of "
          "dry rock under the effective stress, stress plus pore pressure. The others are for "
          "comparison and ten times as expensive: plastic: the published form, for its "
          "calibrations; "
          "elastic centre: the same about the strain of zero effective stress"},
         {&P::undrained_moduli,
          "Undrained moduli",
          {"biot", "arenisca3"},
          0,
          "of the plastic form; arenisca3: those of the published code (2 to 5 % too stiff, no "
          "B1), "
          "for its "
          "calibrations"}}};
  }
  static std::string check(const Parameters& /*p*/) { return {}; }
};

}  // namespace barreno::arenisca
