// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "files/text_file.hpp"
#include "state/state.hpp"

#include <memory>
#include <vector>

namespace barreno {

/// Numbers of the whole run at one instant, the same on every rank.
struct RunTotals {
  Ledger ledger;
  double particles = 0.0;
  double particle_steps = 0.0;  ///< advanced
  double skipped_steps = 0.0;   ///< left as they were
  StepShares step_shares;       ///< of particle_steps
  StepLimits step_limits;
  double time = 0.0;              ///< [time]
  std::vector<double> pore_flow;  ///< see pore_flow_values
  std::vector<double> reactions;  ///< impulses on rigid bodies, see reaction_impulses
};

/// Collective.
RunTotals sum_totals(const State& state);

/// What a row needs of the one before: forces are means over the time between.
struct PreviousRow {
  double time = 0.0;
  std::vector<double> reactions;  ///< none before the first row
};

/// history.csv: time, particles, every term of the ledger, the errors of the three balances and the
/// tally of removed and held particles, and the reactions of rigid bodies; a row per call.
class HistoryWriter {
public:
  /// @param kept    bytes of an old file that stay, see LineFile
  /// @param before  the last row of the old file
  HistoryWriter(
      const Scene& scene,
      const Comm& comm,
      const std::filesystem::path& path,
      std::uintmax_t kept = 0,
      const PreviousRow& before = {}
  );
  /// Collective. @throws FileError on every rank
  void write(const Comm& comm, const Clock& clock, const RunTotals& totals);

  std::uintmax_t bytes() const { return file_ ? file_->bytes() : 0; }
  const PreviousRow& last_row() const { return before_; }

private:
  std::unique_ptr<LineFile> file_;  ///< root only
  PreviousRow before_;
};

}  // namespace barreno
