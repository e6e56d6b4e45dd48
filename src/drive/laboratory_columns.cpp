// SPDX-License-Identifier: BSD-3-Clause
#include "drive/laboratory_columns.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <cmath>

namespace barreno {
namespace {

/// Value of a comment, one of two words; the first is the default, unless it has to be said.
bool is_second_word(
    const TableText& table,
    const std::string& key,
    const std::string& first,
    const std::string& second,
    const std::string& missing,
    const std::string& source
) {
  for (const TableComment& comment : table.comments) {
    if (comment.key != key) continue;
    const std::string word = lower_case(comment.value);
    if (word == first || word == second) return word == second;
    input::refuse_value(
        source,
        std::string("line ").append(std::to_string(comment.line)).append(", ").append(key),
        comment.value,
        std::string("is neither ")
            .append(first)
            .append(" nor ")
            .append(second)
            .append("; write one of the two")
    );
  }
  if (!missing.empty()) input::refuse(source, "", missing);
  return false;
}

void check_unit(
    const TableText& table,
    std::size_t column,
    const LaboratoryColumn& laboratory,
    const std::string& source
) {
  if (!table.units[column].empty()) return;
  for (const TableLine& row : table.rows) {
    const std::string& cell = row.cells[column];
    const bool plain = cell.find_first_not_of("0123456789+-.eE") == std::string::npos;
    if (!plain || cell.find_first_of("123456789") == std::string::npos) continue;
    const std::string name = table.names[column];
    input::refuse_value(
        source,
        "line " + std::to_string(row.number) + ", " + name,
        cell,
        "has no unit; write the column as \"" + name + (laboratory.is_strain ? " [%]" : " [MPa]") +
            "\", in the unit that it has"
    );
  }
}

double logarithm_of(
    double stretch, const std::string& column, int line, const std::string& source
) {
  if (std::isnan(stretch)) return stretch;  // an empty cell
  if (stretch > -1.0) return std::log1p(stretch);
  input::refuse_value(
      source,
      "line " + std::to_string(line) + ", " + column,
      input::exact_text(-stretch),
      "leaves nothing of the specimen; check the unit of the column"
  );
}

}  // namespace

const std::vector<LaboratoryColumn>& laboratory_columns() {
  static const std::vector<LaboratoryColumn> all = {
      {"axial_strain", {0}, true},
      {"radial_strain", {1, 2}, true},
      {"axial_stress", {0}, false},
      {"radial_stress", {1, 2}, false},
      {"confinement", {1, 2}, false}};
  return all;
}

const LaboratoryColumn* find_laboratory_column(const std::string& name) {
  for (const LaboratoryColumn& column : laboratory_columns())
    if (name == column.name) return &column;
  return nullptr;
}

void from_laboratory(const TableText& table, TableRows& rows, const std::string& source) {
  const std::size_t width = table.names.size();
  for (std::size_t i = 0; i < width; ++i) {
    const LaboratoryColumn* const column = find_laboratory_column(table.names[i]);
    if (column == nullptr) continue;
    check_unit(table, i, *column, source);
    const bool negative = is_second_word(
        table,
        "compression",
        "positive",
        "negative",
        "has the column " + table.names[i] +
            " without its sign; add a line \"# compression: positive\" (or negative)",
        source
    );
    const bool logarithmic =
        is_second_word(table, "strain", "engineering", "logarithmic", "", source);
    for (std::size_t row = 0; row < rows.lines.size(); ++row) {
      double& value = rows.values[row * width + i];
      if (!negative) value = 0.0 - value;
      if (column->is_strain && !logarithmic)
        value = logarithm_of(value, table.names[i], rows.lines[row], source);
    }
    if (column->is_strain && !logarithmic)
      rows.notes.push_back(table.names[i] + " is read as change over original length.");
  }
}

}  // namespace barreno
