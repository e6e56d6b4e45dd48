// SPDX-License-Identifier: BSD-3-Clause
#include "output/watch_ledger.hpp"

#include "files/text_file.hpp"

#include <cmath>

namespace barreno {

void watch_ledger(const Ledger& ledger, double time, Ledger& watched, Progress& progress) {
  const std::string when = number_line(" by t = %.4g s.", time);
  const auto warn = [&](const std::string& kind, double before, double now) {
    if (now > before) progress.warn(kind, counted(now, kind) + when, std::lround(now - before));
  };
  for (std::size_t cause = 0; cause < ledger.removed.size(); ++cause)
    warn(
        std::string("particles removed (") + removal_names[cause] + ")",
        watched.removed[cause].count,
        ledger.removed[cause].count
    );
  warn("particles held as debris", watched.held, ledger.held);
  warn("particles torn off loaded surfaces", watched.unloaded, ledger.unloaded);
  warn("steps retried with a smaller dt", watched.retried_steps, ledger.retried_steps);
  watched = ledger;
}

}  // namespace barreno
