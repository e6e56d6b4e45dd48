// SPDX-License-Identifier: BSD-3-Clause
#include "state/ledger_table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace barreno {

const char* unit_of(Conserved what) {
  switch (what) {
    case Conserved::mass:
      return "kg";
    case Conserved::momentum:
      return "kg m/s";
    case Conserved::energy:
      return "J";
    case Conserved::none:
      break;
  }
  return "-";
}

const char* word_of(Part part) {
  switch (part) {
    case Part::held:
      return "held";
    case Part::supplied:
      return "supplied";
    case Part::worked:
      return "worked";
    case Part::exchanged:
      return "exchanged";
    case Part::numerical:
      return "numerical";
    case Part::outside:
      break;
  }
  return "outside";
}

namespace {

LedgerRow count_row(
    const char* name,
    int column,
    const char* summary,
    std::function<double(const Ledger&)> value,
    const char* meaning,
    const std::string& warning
) {
  return {
      name, meaning, std::move(value), Conserved::none, Part::outside, column, summary, warning};
}

/// summary.json has these by cause.
LedgerRow removed_row(RemovalCause cause, int column, const char* meaning) {
  const auto c = static_cast<std::size_t>(cause);
  const std::string name = std::string("removed_") + removal_names[c];
  const std::string warning = std::string("particles removed (") + removal_names[c] + ")";
  return count_row(
      name.c_str(),
      column,
      "",
      [c](const Ledger& l) { return l.removed[c].count; },
      meaning,
      warning
  );
}

std::vector<LedgerRow> count_rows() {
  using Cause = RemovalCause;
  return {
      removed_row(Cause::left_grid, 17, "particles removed so far because they left the grid"),
      removed_row(Cause::not_finite, 18, "because a value was not finite"),
      removed_row(Cause::material_failure, 19, "because the material could not be updated"),
      removed_row(Cause::expanded, 20, "because they expanded beyond `Step/Largest Expansion`"),
      removed_row(Cause::inverted, 21, "because they turned inside out"),
      count_row(
          "held",
          22,
          "held_particles",
          &Ledger::held,
          "particles that became stress-free debris (`Bad Particles` is `hold`)",
          "particles held as debris"
      ),
      count_row(
          "unloaded",
          0,
          "unloaded_particles",
          &Ledger::unloaded,
          "particles that were torn off a loaded surface, and so carry no load any more",
          "particles torn off loaded surfaces"
      ),
      count_row(
          "retried",
          23,
          "retried_steps",
          &Ledger::retried_steps,
          "steps repeated with a smaller `dt`",
          "steps retried with a smaller dt"
      ),
      count_row(
          "clipped",
          26,
          "clipped_particles",
          &Ledger::clipped,
          "particles whose domain is now cut at `Step/Largest Domain`",
          ""
      )};
}

}  // namespace

const std::vector<LedgerRow>& ledger_table() {
  static const std::vector<LedgerRow> table = [] {
    std::vector<LedgerRow> all = balance_rows();
    for (const LedgerRow& row : count_rows()) all.push_back(row);
    return all;
  }();
  return table;
}

const LedgerRow& ledger_row(const std::string& name) {
  for (const LedgerRow& row : ledger_table())
    if (row.name == name) return row;
  throw std::logic_error("ledger_table() has no row " + name);
}

std::vector<const LedgerRow*> ledger_columns() {
  std::vector<const LedgerRow*> columns;
  for (const LedgerRow& row : ledger_table())
    if (row.column > 0) columns.push_back(&row);
  std::sort(columns.begin(), columns.end(), [](const LedgerRow* a, const LedgerRow* b) {
    return a->column < b->column;
  });
  return columns;
}

namespace {

template <class Visitor>
void for_each_part(Conserved what, Part part, Visitor&& visit) {
  for (const LedgerRow& row : ledger_table())
    if (row.unit == what && row.part == part) visit(row);
}

}  // namespace

double add_rows(const Ledger& ledger, Conserved what, Part part, double start, double sign) {
  double sum = start;
  for_each_part(what, part, [&](const LedgerRow& row) { sum += sign * row.value(ledger); });
  return sum;
}

double add_magnitudes(const Ledger& ledger, Conserved what, Part part, double start) {
  double sum = start;
  for_each_part(what, part, [&](const LedgerRow& row) { sum += std::abs(row.value(ledger)); });
  return sum;
}

double largest_magnitude(const Ledger& ledger, Conserved what, Part part) {
  double largest = 0.0;
  for_each_part(what, part, [&](const LedgerRow& row) {
    largest = std::max(largest, std::abs(row.value(ledger)));
  });
  return largest;
}

std::string ledger_markdown() {
  std::ostringstream out;
  for (const LedgerRow& row : ledger_table())
    if (!row.summary.empty())
      out << "| `" << row.summary << "` | " << unit_of(row.unit) << " | " << row.meaning << " |\n";
  return out.str();
}

}  // namespace barreno
