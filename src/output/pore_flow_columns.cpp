// SPDX-License-Identifier: BSD-3-Clause
#include "output/pore_flow_columns.hpp"

#include "state/ledger_table.hpp"

namespace barreno {
namespace {

using Flow = PoreFlowState;

double fluid_error(const Flow& flow) {
  const double left = flow.fluid + flow.removed - flow.initial_fluid - flow.inflow;
  return flow.initial_fluid > 0.0 ? left / flow.initial_fluid : 0.0;
}

/// A row of the ledger that stands among them.
PoreFlowColumn column_of_ledger(const std::string& name) {
  const LedgerRow& row = ledger_row(name);
  return {name, unit_of(row.unit), row.meaning, [&row](const Flow&, const Ledger& ledger) {
            return row.value(ledger);
          }};
}

std::vector<PoreFlowColumn> make_pore_flow_table() {
  return {
      {"fluid",
       "m3",
       "with Pore Flow: fluid in the pores at its initial density, at the last solve, as all "
       "volumes here",
       [](const Flow& flow, const Ledger&) { return flow.fluid; }},
      {"fluid_inflow",
       "m3",
       "fluid that flowed in through the surfaces of rock; negative: out",
       [](const Flow& flow, const Ledger&) { return flow.inflow; }},
      {"fluid_removed",
       "m3",
       "fluid in particles that were removed",
       [](const Flow& flow, const Ledger&) { return flow.removed; }},
      {"fluid_error",
       "-",
       "what the balance of the fluid leaves over, relative to `fluid`",
       [](const Flow& flow, const Ledger&) { return fluid_error(flow); }},
      column_of_ledger("fluid_work"),
      {"pore_solves",
       "-",
       "linear solves of the pore pressure so far",
       [](const Flow& flow, const Ledger&) { return static_cast<double>(flow.solves); }},
      {"pore_iterations",
       "-",
       "iterations of all these solves",
       [](const Flow& flow, const Ledger&) { return static_cast<double>(flow.iterations); }}};
}

}  // namespace

const std::vector<PoreFlowColumn>& pore_flow_table() {
  static const std::vector<PoreFlowColumn> table = make_pore_flow_table();
  return table;
}

std::vector<std::string> pore_flow_columns(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.pore_flow.on())
    for (const PoreFlowColumn& column : pore_flow_table()) names.push_back(column.name);
  return names;
}

std::vector<double> pore_flow_values(const State& state, const Ledger& ledger) {
  std::vector<double> values;
  if (state.pore_flow.on)
    for (const PoreFlowColumn& column : pore_flow_table())
      values.push_back(column.value(state.pore_flow, ledger));
  return values;
}

}  // namespace barreno
