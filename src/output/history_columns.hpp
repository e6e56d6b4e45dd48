// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/history_writer.hpp"

#include <functional>
#include <string>
#include <vector>

namespace barreno {

/// What a row of history.csv is read from.
struct HistoryInstant {
  const Clock& clock;
  const RunTotals& totals;
};

/// A column of history.csv that every scene has.
struct HistoryColumn {
  std::string name, unit, meaning;
  std::function<double(const HistoryInstant&)> value;
};

/// Time, step and particles, then ledger_columns(). Those of pore flow (pore_flow_columns) and of
/// rigid bodies (reaction_columns) come behind them, where a scene has them.
const std::vector<HistoryColumn>& history_columns();

/// The table of docs/output.md: these, those of pore flow and of rigid bodies.
std::string history_markdown();

}  // namespace barreno
