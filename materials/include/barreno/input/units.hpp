// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"

#include <string>
#include <string_view>

namespace barreno::input {

/// Entry of decks and cards that names the system of their plain numbers.
inline constexpr const char* units_word = "Units";

/// A unit as mantissa * 10^exponent in SI. The exponent is kept apart so that decimal units convert
/// to the double nearest to the decimal number: 12.7 mm is the literal 0.0127, not 12.7 * 0.001.
struct Unit {
  double mantissa = 1.0;
  int exponent = 0;
  Dimension dimension{};
  double zero = 0.0;  ///< its zero in SI, for degrees Celsius [temperature]
};

double to_si(double value, const Unit& unit);

/// A consistent system of units, in which a deck's plain numbers are read.
struct UnitSystem {
  std::string name = "SI";
  Unit length{1.0, 0, dimension::length};
  Unit time{1.0, 0, dimension::time};
  Unit mass{1.0, 0, dimension::mass};

  Unit unit_of(const Dimension& dimension) const;
};

/// "SI", or a unit of length, of time and of mass in any order, joined by '-': "mm-us-g", "m-s-kg".
/// Temperatures are always in kelvin. Throws InputError with the part of the sentence after the
/// value.
UnitSystem read_unit_system(const std::string& name);

/// A unit with products, quotients and powers: "mm", "g/cm3", "kg m^-3", "J/(kg K)".
/// Throws InputError with the part of the sentence after the value.
Unit read_unit(std::string_view text);

/// A number with an optional unit suffix, consumed whole, in SI; without suffix it is in `units`.
/// Throws InputError with the part of the sentence after the value.
double read_quantity(std::string_view text, const Dimension& dimension, const UnitSystem& units);

/// "a length", "a stress", "a number without unit", for sentences.
std::string words_of(const Dimension& dimension);
/// "m", "Pa", "kg/m3"; empty without dimension.
std::string si_unit_of(const Dimension& dimension);
/// A value as a user may write it: "12.7 mm", "10 ksi".
std::string example_of(const Dimension& dimension);

}  // namespace barreno::input
