// SPDX-License-Identifier: BSD-3-Clause
#include "drive/plot_text.hpp"

#include "drive/yield_view.hpp"
#include "files/text_file.hpp"

#include <algorithm>

namespace barreno {
namespace {

constexpr const char* components[] = {"xx", "yy", "zz", "xy", "yz", "zx"};

/// Column of the history that is the pressure of a pore fluid; that behind the last where none is.
std::size_t pressure_history_of(const Material& material) {
  const auto fields =
      std::visit([](const auto& model) { return model.history_table(); }, material.model);
  const auto found = std::find_if(fields.begin(), fields.end(), [](const HistoryField& field) {
    return std::string(field.name) == "pore_pressure";
  });
  return static_cast<std::size_t>(found - fields.begin());
}

std::string model_name(const Material& material) {
  return std::visit([](const auto& model) { return std::string(model.name); }, material.model);
}

/// Dry rock's models of two phases have the column too; it is told where there is fluid.
bool holds_fluid(const std::vector<DrivenState>& states, std::size_t column) {
  return std::any_of(states.begin(), states.end(), [&](const DrivenState& state) {
    return column < state.history.size() && state.history[column] != 0.0;
  });
}

}  // namespace

std::string plot_text(
    const Material& material,
    const std::vector<DrivenState>& states,
    const std::string& yield_table,
    const std::string& path
) {
  const std::size_t pores = pressure_history_of(material);
  const bool wet = holds_fluid(states, pores);
  std::string text = "# title: " + model_name(material) + " of '" + material.name + "' along " +
                     path + "\n# bounded: " + bounded_stress_words(material) + "\ntime";
  for (const char* tensor : {"strain_", "stress_", "bounded_"})
    for (const char* component : components) text += std::string(",") + tensor + component;
  text += wet ? ",pore_pressure\n" : "\n";
  for (std::size_t i = 0; i < states.size(); ++i) {
    const DrivenState& state = states[i];
    const auto view = yield_view(material, state, states[i == 0 ? 0 : i - 1]);
    std::vector<double> values{state.time};
    for (const Sym3& s : {state.strain, state.stress, view ? view->bounded : state.stress})
      values.insert(values.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
    if (wet) values.push_back(state.history[pores]);
    text += csv_line(values) + "\n";
  }
  return text + "# yield surface\n" + yield_table;
}

}  // namespace barreno
