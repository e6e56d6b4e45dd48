// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/units.hpp"

#include <vector>

namespace barreno::input {
namespace {

struct NamedDimension {
  Dimension dimension;
  const char *words, *si, *example;
};
const std::vector<NamedDimension>& named_dimensions() {
  static const std::vector<NamedDimension> names = {
      {dimension::none, "a number without unit", "", "0.5"},
      {dimension::length, "a length", "m", "12.7 mm"},
      {dimension::area, "an area", "m2", "1e-15 m2"},
      {dimension::volume, "a volume", "m3", "1 cm3"},
      {dimension::time, "a time", "s", "100 us"},
      {dimension::mass, "a mass", "kg", "20 g"},
      {dimension::temperature, "a temperature", "K", "294 K"},
      {dimension::velocity, "a velocity", "m/s", "4340 m/s"},
      {dimension::density, "a density", "kg/m3", "2.3 g/cm3"},
      {dimension::stress, "a stress", "Pa", "10 ksi"},
      {dimension::viscosity, "a viscosity", "Pa s", "1e-3 Pa s"},
      {dimension::compliance, "a compliance", "1/Pa", "1.5 1/GPa"},
      {dimension::rate, "a rate", "1/s", "1000 1/s"},
      {dimension::specific_energy, "an energy per mass", "J/kg", "300 kJ/kg"},
      {dimension::heat_capacity, "a heat capacity per mass", "J/(kg K)", "477 J/(kg K)"},
      {dimension::energy_per_area, "an energy per area", "J/m2", "60 J/m2"},
      {{-1, 0, 0, 0}, "a wave number", "1/m", "31.4 1/m"},
      {{2, -2, 1, 0}, "an energy", "J", "1 kJ"},
      {{1, -2, 1, 0}, "a force", "N", "1 kN"},
  };
  return names;
}
const NamedDimension* find_dimension(const Dimension& dimension) {
  for (const auto& named : named_dimensions()) {
    if (named.dimension == dimension) return &named;
  }
  return nullptr;
}

}  // namespace

std::string words_of(const Dimension& dimension) {
  if (const auto* named = find_dimension(dimension)) return named->words;
  return "a quantity in " + si_unit_of(dimension);
}

std::string si_unit_of(const Dimension& d) {
  if (const auto* named = find_dimension(d)) return named->si;
  std::string text;
  const auto add = [&text](const char* unit, int n) {
    if (n == 0) return;
    text += (text.empty() ? "" : " ") + std::string(unit) + (n == 1 ? "" : std::to_string(n));
  };
  add("kg", d.mass);
  add("m", d.length);
  add("s", d.time);
  add("K", d.temperature);
  return text;
}

std::string example_of(const Dimension& dimension) {
  if (const auto* named = find_dimension(dimension)) return named->example;
  return "1 " + si_unit_of(dimension);
}

}  // namespace barreno::input
