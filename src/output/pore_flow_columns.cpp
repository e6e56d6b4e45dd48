// SPDX-License-Identifier: BSD-3-Clause
#include "output/pore_flow_columns.hpp"

namespace barreno {

std::vector<std::string> pore_flow_columns(const Scene& scene) {
  if (!scene.pore_flow.on()) return {};
  return {
      "fluid",
      "fluid_inflow",
      "fluid_removed",
      "fluid_error",
      "fluid_work",
      "pore_solves",
      "pore_iterations"};
}

std::vector<double> pore_flow_values(const State& state, const Ledger& ledger) {
  const PoreFlowState& flow = state.pore_flow;
  if (!flow.on) return {};
  const double left = flow.fluid + flow.removed - flow.initial_fluid - flow.inflow;
  return {
      flow.fluid,
      flow.inflow,
      flow.removed,
      flow.initial_fluid > 0.0 ? left / flow.initial_fluid : 0.0,
      ledger.fluid_work,
      static_cast<double>(flow.solves),
      flow.iterations};
}

}  // namespace barreno
