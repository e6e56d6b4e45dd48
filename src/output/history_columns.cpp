// SPDX-License-Identifier: BSD-3-Clause
#include "output/history_columns.hpp"

#include "output/pore_flow_columns.hpp"
#include "state/ledger_table.hpp"

#include <sstream>

namespace barreno {
namespace {

using Instant = HistoryInstant;

std::vector<HistoryColumn> columns_of_steps() {
  return {
      {"time", "s", "simulated time", [](const Instant& at) { return at.clock.time; }},
      {"step",
       "-",
       "number of steps taken",
       [](const Instant& at) { return static_cast<double>(at.clock.step); }},
      {"dt", "s", "size of the last step", [](const Instant& at) { return at.clock.dt; }},
      {"particles",
       "-",
       "particles now, those of the jet from their launch on",
       [](const Instant& at) { return at.totals.particles; }}};
}

}  // namespace

const std::vector<HistoryColumn>& history_columns() {
  static const std::vector<HistoryColumn> table = [] {
    std::vector<HistoryColumn> all = columns_of_steps();
    for (const LedgerRow* row : ledger_columns())
      all.push_back({row->name, unit_of(row->unit), row->meaning, [row](const Instant& at) {
                       return row->value(at.totals.ledger);
                     }});
    return all;
  }();
  return table;
}

std::string history_markdown() {
  std::ostringstream out;
  const auto add = [&](const std::string& names, const std::string& unit, const std::string& text) {
    out << "| " << names << " | " << unit << " | " << text << " |\n";
  };
  out << "| column | unit | meaning |\n|---|---|---|\n";
  for (const HistoryColumn& column : history_columns())
    add("`" + column.name + "`", column.unit, column.meaning);
  for (const PoreFlowColumn& column : pore_flow_table())
    add("`" + column.name + "`", column.unit, column.meaning);
  add("`NAME_force_x`, `_y`, `_z`",
      "N",
      "with rigid bodies: mean force of the others on body NAME since the row before "
      "(axisymmetric: y alone, of the full circle)");
  add("`NAME_impulse_x`, `_y`, `_z`", "kg m/s", "impulse of the others on body NAME since the start"
  );
  return out.str();
}

}  // namespace barreno
