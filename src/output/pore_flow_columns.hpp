// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <functional>
#include <string>
#include <vector>

namespace barreno {

/// A column of history.csv that a scene with draining pore fluid has.
struct PoreFlowColumn {
  std::string name, unit, meaning;
  std::function<double(const PoreFlowState&, const Ledger&)> value;
};
const std::vector<PoreFlowColumn>& pore_flow_table();

/// Their names, none in other scenes, and what the comment of the file says of them.
std::vector<std::string> pore_flow_columns(const Scene& scene);
inline constexpr const char* pore_flow_note =
    "; fluid in the pores, fluid_inflow through the surfaces of rock and fluid_removed with "
    "particles: m3 at the initial density, of the last solve; fluid_error: what they leave over, "
    "over fluid; fluid_work J: p dv where fluid flows in; pore_iterations: of all solves";

/// Their values, from the ledger of all ranks; none in other scenes.
std::vector<double> pore_flow_values(const State& state, const Ledger& ledger);

}  // namespace barreno
