// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/anomalies.hpp"
#include "state/ledger.hpp"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace barreno {

/// Share of the energy put in that a term of numerical errors may have before a run ends with a
/// warning [-]. Both terms are watched: where they cancel, their sum shows nothing.
inline constexpr double largest_numerical_share = 0.1;
/// The kind of that warning.
inline constexpr const char* numerical_energy_kind = "numerical errors above 10 % of the energy";

/// Energies at one time of a run [energy].
struct EnergyRow {
  double time = 0.0;
  double put_in = 0.0;  ///< as Balance::put_in of energy_balance
  double stress_integration = 0.0, transfer = 0.0;
};

/// What numerical errors did to the energy of a run.
struct NumericalShares {
  /// Largest of the run, with their signs, relative to the most energy that was put in, and at the
  /// end to the balance's [-].
  double stress_integration = 0.0, transfer = 0.0;
  /// First row at which one of them exceeds largest_numerical_share [time]; not a number: none does
  double since = std::numeric_limits<double>::quiet_NaN();
  bool too_large() const;
};

/// Rows of history.csv, and the ledger as the last one. The file holds the rows before a resume
/// too, so that nothing of them need be kept elsewhere. A file or row that cannot be read adds
/// none.
std::vector<EnergyRow> energy_rows(
    const std::filesystem::path& history, const Ledger& ledger, double time
);

NumericalShares largest_shares(const std::vector<EnergyRow>& rows);

/// Since when, where and what to do, in one sentence; empty unless shares.too_large().
std::string numerical_energy_sentence(
    const Scene& scene, const NumericalShares& shares, const Extremes& extremes
);

}  // namespace barreno
