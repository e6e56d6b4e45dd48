// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/ledger.hpp"

#include <functional>
#include <string>
#include <vector>

namespace barreno {

/// What a balance is about; `none`: a count, or a ratio.
enum class Conserved { mass, momentum, energy, none };
const char* unit_of(Conserved what);

/// What a row is in its balance: held - supplied - worked - exchanged - numerical = remainder.
enum class Part {
  held,       ///< what the bodies have now, or have spent
  supplied,   ///< came with bodies and slugs
  worked,     ///< what forces gave, of either sign: work and impulses
  exchanged,  ///< what pore fluid brought with it, of either sign
  numerical,  ///< what the method has added to it (< 0: taken from it)
  outside     ///< in no balance
};
const char* word_of(Part part);

/// A row of the ledger: this is all that is known of it. Balances, history.csv, summary.json,
/// warnings, the report's picture of the energy and docs/output.md follow.
struct LedgerRow {
  std::string name;  ///< of its column in history.csv, or of its number in summary.json
  std::string meaning;
  std::function<double(const Ledger&)> value;  ///< a member, or what follows from several
  Conserved unit;                              ///< of its balance, if it has a part in one
  Part part;
  int column;           ///< its place in history.csv, from 1; 0: it has none
  std::string summary;  ///< its path in summary.json, joined by dots; empty: it is not there
  std::string warning;  ///< kind of the warning that is given where a count grows; empty: none
};

/// In the order of the sums of the balances, so that their bits stay. A member of LedgerTerms
/// without a row, and columns whose places are not 1, 2, 3 ..., fail LedgerTable (test_balance).
const std::vector<LedgerRow>& ledger_table();
/// Those of them that are not counts.
std::vector<LedgerRow> balance_rows();
/// @pre the table has the name
const LedgerRow& ledger_row(const std::string& name);

/// Rows that have a column in history.csv, in their order there.
std::vector<const LedgerRow*> ledger_columns();

/// start + sign times every row that is this part of a balance, one after the other.
double add_rows(const Ledger& ledger, Conserved what, Part part, double start, double sign = 1.0);
double add_magnitudes(const Ledger& ledger, Conserved what, Part part, double start);
double largest_magnitude(const Ledger& ledger, Conserved what, Part part);

/// Rows of the table of summary.json in docs/output.md.
std::string ledger_markdown();

}  // namespace barreno
