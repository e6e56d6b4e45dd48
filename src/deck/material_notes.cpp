// SPDX-License-Identifier: BSD-3-Clause
#include "deck/material_notes.hpp"

#include "base/format.hpp"
#include "deck/deck.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/material_section.hpp"

#include <Teuchos_ParameterList.hpp>

#include <barreno/input/scan_xml.hpp>
#include <barreno/input/units.hpp>
#include <barreno/plausible.hpp>
#include <barreno/registry.hpp>
#include <cmath>

namespace barreno {
namespace {

using Teuchos::ParameterList;

double value_of(const ParameterList& values, const std::string& name) {
  return values.isType<double>(name) ? values.get<double>(name) : 0.0;
}

std::string unit_of(const ModelDescription& model, const std::string& parameter) {
  for (const input::Entry& entry : card_section(model).entries)
    if (entry.name == parameter) return input::si_unit_of(entry.dimension);
  return {};
}

std::string range_note(
    const PlausibleRange& range, double value, const std::string& unit, const std::string& path
) {
  const bool stress = unit == "Pa";
  return input::join(path, range.parameter) + format(" = %.4g ", value) + unit +
         format(
             " is outside the usual %s (%g to %g ",
             range.of_magnitude ? "magnitudes" : "range",
             range.lower,
             range.upper
         ) +
         unit + "); if a unit was forgotten, write it behind the number" +
         (stress ? format(", \"%.4g MPa\" or \"%.4g GPa\"", value, value) : std::string());
}

/// Grains of quartz, the most frequent of reservoir rock, and water [kg/m3].
constexpr double grains = 2650.0, water = 1000.0;

/// Whether the density, taken as that of the dry rock, gives grains nearer to quartz than taken as
/// that of the rock with water in its pores.
bool looks_dry(double density, double porosity) {
  const double if_dry = density / (1.0 - porosity);
  const double if_wet = (density - porosity * water) / (1.0 - porosity);
  return std::fabs(if_dry - grains) < std::fabs(if_wet - grains);
}

std::string dry_note(const ParameterList& values, const std::string& path) {
  if (value_of(values, "fluid_B0") <= 0.0 || value_of(values, "Fluid Density") > 0.0) return {};
  const double density = value_of(values, "Density");
  const double porosity = 1.0 - std::exp(-value_of(values, "p3_crush_curve"));
  constexpr double least = 0.01;  // of pores, below which the fluid weighs next to nothing
  if (porosity < least || !looks_dry(density, porosity)) return {};
  return input::join(path, "Density") +
         format(
             " = %.4g kg/m3 looks like that of the dry rock, while fluid_B0 fills its pores (%.3g "
             "of the volume); ",
             density,
             porosity
         ) +
         format(
             "write Fluid Density, for water 1000 kg/m3, and the rock starts with %.4g kg/m3",
             density + porosity * water
         );
}

}  // namespace

std::vector<std::string> material_notes(const ParameterList& values, const std::string& path) {
  std::vector<std::string> notes;
  if (!values.isType<std::string>("Model")) return notes;
  const ModelDescription& model = find_model(values.get<std::string>("Model"));
  for (const PlausibleRange& range : plausible_ranges(model.name)) {
    const double value = value_of(values, range.parameter);
    if (!range.holds(value))
      notes.push_back(range_note(range, value, unit_of(model, range.parameter), path));
  }
  if (std::string note = dry_note(values, path); !note.empty()) notes.push_back(std::move(note));
  return notes;
}

std::vector<std::string> material_notes(const Deck& deck) {
  std::vector<std::string> notes;
  const std::string& materials = table_of<MaterialSection>().path;
  for (const std::string& name : deck.lists(materials)) {
    const std::string path = input::join(materials, name);
    for (std::string& note : material_notes(deck.list(path), path))
      notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace barreno
