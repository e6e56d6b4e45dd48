// SPDX-License-Identifier: BSD-3-Clause
#include "output/report_tables.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/material_section.hpp"
#include "jet/rock_permeability.hpp"
#include "output/particle_field_table.hpp"
#include "state/ledger_table.hpp"

#include <barreno/arenisca/parts/list.hpp>
#include <barreno/input/units.hpp>
#include <barreno/registry.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>

namespace barreno {
namespace {

using Tables = nlohmann::ordered_json;

Tables units_of_fields() {
  Tables units;
  for (const ParticleField& field : particle_field_table())
    for (const std::string& name : component_names(field, 3)) units[name] = field.unit;
  for (const ModelDescription& model : describe_models()) {
    for (const auto& fields : {model.history, model.more_history})
      for (const HistoryField& field : fields) {
        const std::string unit = input::si_unit_of(field.dimension);
        units[field.name] = unit.empty() ? "-" : unit;
      }
  }
  return units;
}

Tables energies_of_ledger() {
  Tables parts;
  for (const LedgerRow& row : ledger_table())
    if (row.unit == Conserved::energy && row.part != Part::outside)
      parts[word_of(row.part)].push_back(row.name);
  return parts;
}

template <class List>
void add_parameters(std::set<std::string>& names) {
  for_each_part(List{}, [&](const auto* part) {
    using Part = std::remove_cv_t<std::remove_pointer_t<decltype(part)>>;
    const auto table = Part::parameter_table();
    for (const auto& number : table.numbers) names.insert(number.name);
    for (const auto& choice : table.choices) names.insert(choice.name);
  });
}

/// Entries of an Arenisca material, but for those of shear limits and crush curves beside the
/// published ones.
Tables entries_of_published_surface() {
  std::set<std::string> others;
  add_parameters<arenisca::OtherShearLimits>(others);
  add_parameters<arenisca::OtherCrushCurves>(others);
  Tables names = Tables::array();
  for (const input::Entry& entry : card_section(find_model("Arenisca")).entries)
    if (others.count(entry.name) == 0) names.push_back(entry.name);
  for (const auto& row : table_of<MaterialSection>().entries) names.push_back(row.entry.name);
  return names;
}

/// The report computes the permeability of rock that it averages over rings of its own.
Tables permeability_of_rock() {
  using Law = PermeabilityLaw;
  return {
      {"least", Law::least},
      {"most", Law::most},
      {"of_broken", Law::of_broken},
      {"impaired", Law::impaired}};
}

}  // namespace

std::string report_tables() {
  Tables tables;
  tables["units"] = units_of_fields();
  tables["energy"] = energies_of_ledger();
  tables["permeability"] = permeability_of_rock();
  tables["published_surface"] = entries_of_published_surface();
  return tables.dump(1) + "\n";
}

}  // namespace barreno
