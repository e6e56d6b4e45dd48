// SPDX-License-Identifier: BSD-3-Clause
#include "drive/mixed_path.hpp"

#include "deck/files/read_table.hpp"
#include "drive/laboratory_columns.hpp"
#include "drive/path_table.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <cmath>

namespace barreno {
namespace {

using input::exact_text;

/// Every column that such a path may have; the strains first, then the stresses.
const std::vector<TableColumn>& all_columns() {
  static const std::vector<TableColumn> all = {
      {"strain_xx", dimension::none, true},
      {"strain_yy", dimension::none, true},
      {"strain_zz", dimension::none, true},
      {"strain_xy", dimension::none, true},
      {"strain_yz", dimension::none, true},
      {"strain_zx", dimension::none, true},
      {"stress_xx", dimension::stress, true},
      {"stress_yy", dimension::stress, true},
      {"stress_zz", dimension::stress, true},
      {"stress_xy", dimension::stress, true},
      {"stress_yz", dimension::stress, true},
      {"stress_zx", dimension::stress, true},
      {"pore_pressure", dimension::stress, true},
      {"time", dimension::time}};
  return all;
}
constexpr std::size_t pore_pressure_column = 12, time_column = 13;

std::vector<std::string> known_names() {
  std::vector<std::string> known;
  for (const TableColumn& column : all_columns()) known.emplace_back(column.name);
  for (const LaboratoryColumn& column : laboratory_columns()) known.emplace_back(column.name);
  return known;
}

/// Of the columns that a column of the file prescribes, their index in all_columns().
using Columns = std::vector<std::vector<std::size_t>>;

[[noreturn]] void refuse_name(
    const TableText& table, const std::string& name, const std::string& source
) {
  const std::string nearest = input::nearest_name(name, known_names());
  input::refuse_value(
      source,
      "line " + std::to_string(table.header_line),
      name,
      "is not a column of a path (strain_xx to strain_zx, stress_xx to stress_zx, "
      "axial_strain, radial_strain, axial_stress, confinement, pore_pressure and time are); " +
          (nearest.empty() ? "correct its name" : "did you mean '" + nearest + "'?")
  );
}

void check_columns(const TableText& table, const Columns& columns, const std::string& source) {
  const std::string line = "line " + std::to_string(table.header_line);
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (const std::size_t c : columns[i]) {
      if (std::find(seen.begin(), seen.end(), c) != seen.end())
        input::refuse_value(
            source,
            line,
            table.names[i],
            "is there twice (every column has its own name); take one of them out"
        );
      seen.push_back(c);
    }
  if (std::find(seen.begin(), seen.end(), time_column) != seen.end()) return;
  input::refuse_value(
      source, line, table.header, "has no column of times (a path needs it); begin with time"
  );
}

Columns columns_of(const TableText& table, const std::string& source) {
  Columns columns;
  for (const std::string& name : table.names) {
    columns.emplace_back();
    for (std::size_t c = 0; c < all_columns().size(); ++c)
      if (name == all_columns()[c].name) columns.back().push_back(c);
    if (const LaboratoryColumn* const found = find_laboratory_column(name))
      for (const std::size_t component : found->components)
        columns.back().push_back(component + (found->is_strain ? 0 : 6));
    if (columns.back().empty()) refuse_name(table, name, source);
  }
  check_columns(table, columns, source);
  return columns;
}

/// A cell that says what a component is to be; where it has two columns, one of them is filled.
void take_cell(
    MixedRow& row, std::array<bool, 6>& taken, std::size_t column, const std::string& source
) {
  const std::size_t component = column % 6;
  if (taken[component]) {
    const std::string name = component_names[component];
    input::refuse(
        source,
        "line " + std::to_string(row.line),
        "gives both strain_" + name + " and stress_" + name +
            " (a component is controlled by one of them); leave one of the two cells empty"
    );
  }
  taken[component] = true;
  row.by_stress[component] = column >= 6;
}

std::string gives_neither(const std::string& component) {
  return "gives neither strain_" + component + " nor stress_" + component +
         " (a component is controlled by one of them); fill one of the two cells";
}
std::string leaves_empty(const std::string& column, const std::string& other) {
  return "leaves " + column + " empty, and there is no column " + other +
         " that could control the component instead; write a value, or add that column";
}

/// A component that has a column is given in every row: nothing is assumed about it.
void check_taken(
    const MixedRow& row,
    const std::array<bool, 6>& taken,
    const std::vector<std::size_t>& columns,
    const std::string& source
) {
  for (const std::size_t column : columns) {
    if (column >= pore_pressure_column || taken[column % 6]) continue;
    const std::string name = component_names[column % 6];
    const std::string other = (column < 6 ? "stress_" : "strain_") + name;
    const bool both = std::find(columns.begin(), columns.end(), (column + 6) % 12) != columns.end();
    input::refuse(
        source,
        "line " + std::to_string(row.line),
        both ? gives_neither(name) : leaves_empty(all_columns()[column].name, other)
    );
  }
}

MixedRow row_of(
    const TableRows& table, const Columns& columns, std::size_t row, const std::string& source
) {
  MixedRow out;
  out.line = table.lines[row];
  std::array<bool, 6> taken{};
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    all.insert(all.end(), columns[i].begin(), columns[i].end());
    const double value = table.values[row * columns.size() + i];
    if (std::isnan(value)) continue;  // an empty cell
    for (const std::size_t column : columns[i]) {
      if (column == time_column) {
        out.time = value;
      } else if (column == pore_pressure_column) {
        out.pore_pressure = value;
        out.drained = true;
      } else {
        take_cell(out, taken, column, source);
        out.target[column % 6] = value;
      }
    }
  }
  check_taken(out, taken, all, source);
  return out;
}

void check_first(const MixedPath& path, const std::string& source) {
  const MixedRow& first = path.rows.front();
  for (std::size_t c = 0; c < 6; ++c) {
    if (first.by_stress[c] || first.target[c] == 0.0) continue;
    input::refuse_value(
        source,
        "line " + std::to_string(first.line) + ", strain_" + component_names[c],
        exact_text(first.target[c]),
        "is not the start of a path (strains count from the first row); write 0 there"
    );
  }
}

}  // namespace

bool is_mixed_path(const std::string& text, const std::string& source) {
  std::vector<std::string> known = known_names();
  known.emplace_back("F11");
  const TableText table = split_table(text, known, source);
  if (has_column(table, "F11") || has_column(table, "F22") || has_column(table, "F33"))
    return false;
  return std::any_of(table.names.begin(), table.names.end(), [](const std::string& name) {
    return name.find("str") != std::string::npos || name.find("press") != std::string::npos ||
           name.rfind("conf", 0) == 0;
  });
}

MixedPath read_mixed_path(const std::string& text, const std::string& source) {
  const TableText table_text = split_table(text, known_names(), source);
  const Columns columns = columns_of(table_text, source);
  std::vector<TableColumn> asked;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    asked.push_back(all_columns()[columns[i].front()]);
    asked.back().name = table_text.names[i].c_str();
  }
  TableRows table = read_rows(table_text, asked, source);
  from_laboratory(table_text, table, source);
  check_row_count(table.lines.size(), source);
  MixedPath path;
  path.notes = table.notes;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const MixedRow row = row_of(table, columns, i, source);
    if (i > 0) {
      const MixedRow& before = path.rows.back();
      check_times(before.time, before.line, row.time, row.line, source);
    }
    path.rows.push_back(row);
  }
  check_first(path, source);
  return path;
}

}  // namespace barreno
