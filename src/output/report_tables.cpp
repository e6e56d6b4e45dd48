// SPDX-License-Identifier: BSD-3-Clause
#include "output/report_tables.hpp"

#include "output/particle_field_table.hpp"
#include "state/ledger_table.hpp"

#include <barreno/input/units.hpp>
#include <barreno/registry.hpp>
#include <nlohmann/json.hpp>

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

}  // namespace

std::string report_tables() {
  Tables tables;
  tables["units"] = units_of_fields();
  tables["energy"] = energies_of_ledger();
  return tables.dump(1) + "\n";
}

}  // namespace barreno
