// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/parts.hpp"
#include "barreno/plausible.hpp"

#include <sstream>
#include <string>

namespace barreno::metal {

/// The bulk modulus at rest, which an equation of state tells the rules of the other parts.
struct BulkModulus {
  double value;         ///< [stress]
  const char* formula;  ///< of parameters, for sentences
  const char* inputs;   ///< "the three": it and a modulus that it is compared with
};
inline std::ostream& operator<<(std::ostream& text, const BulkModulus& bulk) {
  return text << "the bulk modulus " << bulk.value << " = " << bulk.formula;
}

/// A state at rest on the isentrope through the unstrained cold state.
struct IsentropeState {
  bool possible = false;
  double compression = 0.0;        ///< eta = 1 - V / V_ref [-]
  double energy = 0.0;             ///< per reference volume [stress]
  double temperature_ratio = 1.0;  ///< to the temperature of the unstrained state
};

/// Rules of every strength: Poisson's ratio, and a melting point above the start.
inline std::string check_solid(
    double shear_modulus, double room_temperature, double melt_temperature, const BulkModulus& bulk
) {
  std::ostringstream text;
  if (melt_temperature <= room_temperature) {
    text << "Melt Temperature = " << melt_temperature
         << " does not exceed Room Temperature = " << room_temperature
         << " (the metal would be molten at the start); give both in kelvin.";
  } else if (shear_modulus > 1.5 * bulk.value) {
    text << "Shear Modulus = " << shear_modulus << " exceeds 1.5 times " << bulk
         << " (Poisson's ratio would be negative); check the units of " << bulk.inputs << '.';
  }
  return text.str();
}

/// The history of a strength that remembers the plastic strain alone.
template <class R>
struct PlasticStrainOf {
  R plastic_strain{};
};
inline std::vector<HistoryField> plastic_strain_table() {
  return {{"plastic_strain", dimension::none, "equivalent plastic strain"}};
}

}  // namespace barreno::metal
