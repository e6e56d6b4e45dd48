// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jet/depth.hpp"
#include "jet/rest.hpp"
#include "jet/rock_zones.hpp"
#include "jet/table.hpp"
#include "output/anomalies.hpp"
#include "output/history_writer.hpp"
#include "output/output.hpp"
#include "output/warnings/numerical_energy.hpp"

#include <map>
#include <optional>

namespace barreno {

/// One phase over all ranks.
struct PhaseSummary {
  std::string label;
  double mean_seconds = 0.0, largest_seconds = 0.0;  ///< of the ranks
  long calls = 0;                                    ///< of the root
};

/// Work outside of the steps over all ranks (base/work_counts.hpp).
struct WorkSummary {
  const char* label = "";
  double sum = 0.0, largest = 0.0;  ///< of the ranks
};

/// What summary.json says beside the totals; the same names there.
struct RunSummary {
  int ranks = 1;
  double wall_seconds = 0.0;  ///< from the first output to the last
  double cpu_seconds = 0.0;   ///< of the processors in the same time, over all ranks
  double bytes_per_particle = 0.0;
  double peak_resident_bytes = 0.0;  ///< sum of the ranks' peaks
  double largest_rank_peak_bytes = 0.0;
  std::vector<PhaseSummary> phases;
  std::vector<WorkSummary> work;
  std::vector<Anomalies> anomalies;  ///< by material
  NumericalShares numerical;         ///< largest of the run
  std::string numerical_warning;     ///< of them; empty: they are small
  std::map<std::string, long> warnings;
  std::optional<JetAudit> formed_jet;  ///< of a Jet Monitor
  std::optional<Rest> rest;            ///< of a launched jet's hole; valid on the root
  std::vector<RockZones> zones;        ///< around that hole, by body
};

/// Collects memory, phases and kinematic anomalies over the ranks. Collective.
/// @param cpu_seconds  of this rank
RunSummary summarise(
    const Scene& scene, const State& state, double wall_seconds, double cpu_seconds
);

/// The text of summary.json.
std::string summary_text(
    const Scene& scene,
    const State& state,
    const RunDescription& run,
    const RunTotals& totals,
    const Penetration& penetration,
    const RunSummary& summary,
    const RunVerdict& verdict
);

}  // namespace barreno
