// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"

#include <cstdio>
#include <string>

namespace barreno {

/// Parameters of Poroelastic, their table and what contradicts among them.
struct PoroelasticParameters {
  double bulk_modulus, shear_modulus, porosity, fluid_bulk_modulus;
  double grain_bulk_modulus = 0.0, biot_coefficient = 1.0, initial_pressure = 0.0;
};

inline ParameterTable<PoroelasticParameters> poroelastic_table() {
  using P = PoroelasticParameters;
  namespace d = dimension;
  const Bounds fraction{0.0, 1.0, true, true};
  return {
      {required(&P::bulk_modulus, "Bulk Modulus", d::stress, above(0.0), "drained bulk modulus K"),
       required(&P::shear_modulus, "Shear Modulus", d::stress, at_least(0.0), "shear modulus G"),
       required(&P::porosity, "Porosity", d::none, fraction, "pore volume over volume, phi"),
       required(
           &P::fluid_bulk_modulus,
           "Fluid Bulk Modulus",
           d::stress,
           at_least(0.0),
           "bulk modulus of the pore fluid, Kf; 0: none"
       ),
       optional(
           &P::grain_bulk_modulus,
           "Grain Bulk Modulus",
           d::stress,
           at_least(0.0),
           0.0,
           "bulk modulus of the grains, Ks: alpha = 1 - K/Ks; 0: set by the Biot coefficient"
       ),
       optional(
           &P::biot_coefficient,
           "Biot Coefficient",
           d::none,
           between(0.0, 1.0),
           1.0,
           "alpha, instead of the grains' modulus Ks = K/(1 - alpha); 1: incompressible grains"
       ),
       optional(
           &P::initial_pressure,
           "Initial Pore Pressure",
           d::stress,
           any(),
           0.0,
           "initial pressure of the fluid, regardless of the confinement"
       )},
      {}};
}

/// alpha = 1 - K/Ks; as given where the grains are not.
inline double biot_coefficient(const PoroelasticParameters& p) {
  if (p.grain_bulk_modulus > 0.0) return 1.0 - p.bulk_modulus / p.grain_bulk_modulus;
  return p.biot_coefficient;
}

/// 1/M = phi/Kf + (alpha - phi)/Ks with 1/Ks = (1 - alpha)/K; 0 without fluid [1/stress].
inline double poroelastic_storage(const PoroelasticParameters& p) {
  if (!(p.fluid_bulk_modulus > 0.0)) return 0.0;
  const double alpha = biot_coefficient(p);
  return p.porosity / p.fluid_bulk_modulus + (alpha - p.porosity) * (1.0 - alpha) / p.bulk_modulus;
}

/// Rules across the parameters, a sentence that names one, or empty.
inline std::string check_poroelastic(const PoroelasticParameters& p) {
  char text[400];
  const auto say = [&](const char* format, double a, double b) {
    std::snprintf(text, sizeof text, format, a, b);
    return std::string(text);
  };
  if (p.grain_bulk_modulus > 0.0 && p.biot_coefficient != 1.0) {
    return say(
        "Grain Bulk Modulus = %.6g and Biot Coefficient = %.6g are both given (one follows from "
        "the other, alpha = 1 - K/Ks); leave one out.",
        p.grain_bulk_modulus,
        p.biot_coefficient
    );
  }
  const double alpha = biot_coefficient(p);
  if (alpha < p.porosity && p.grain_bulk_modulus > 0.0) {
    return say(
        "Grain Bulk Modulus = %.6g gives a Biot coefficient 1 - K/Ks = %.6g below the porosity "
        "(the rock would be stiffer than its grains allow); raise it, or lower Bulk Modulus or "
        "Porosity.",
        p.grain_bulk_modulus,
        alpha
    );
  }
  if (alpha < p.porosity) {
    return say(
        "Biot Coefficient = %.6g is below Porosity = %.6g (the grains would store negative "
        "volume); choose one between the porosity and 1.",
        alpha,
        p.porosity
    );
  }
  if (p.initial_pressure != 0.0 && p.fluid_bulk_modulus == 0.0) {
    return say(
        "Initial Pore Pressure = %.6g needs a fluid, but Fluid Bulk Modulus = %.6g (dry rock); set "
        "that, or the pressure to 0.",
        p.initial_pressure,
        p.fluid_bulk_modulus
    );
  }
  return {};
}

}  // namespace barreno
