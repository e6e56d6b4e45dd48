// SPDX-License-Identifier: BSD-3-Clause
#include "output/watch_ledger.hpp"

#include "files/text_file.hpp"
#include "state/ledger_table.hpp"

#include <cmath>

namespace barreno {

void watch_ledger(const Ledger& ledger, double time, Ledger& watched, Progress& progress) {
  const std::string when = number_line(" by t = %.4g s.", time);
  const auto warn = [&](const std::string& kind, double before, double now) {
    if (now > before) progress.warn(kind, counted(now, kind) + when, std::lround(now - before));
  };
  for (const LedgerRow& row : ledger_table())
    if (!row.warning.empty()) warn(row.warning, row.value(watched), row.value(ledger));
  watched = ledger;
}

}  // namespace barreno
