// SPDX-License-Identifier: BSD-3-Clause
#include "drive/mixed_path.hpp"

#include "deck/files/read_table.hpp"
#include "drive/path_table.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <cmath>
#include <sstream>

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

struct Header {
  int line = 0;
  std::vector<std::string> names;
};

Header header_of(const std::string& text) {
  std::istringstream stream(text);
  Header header;
  for (std::string line; std::getline(stream, line);) {
    ++header.line;
    std::string packed;
    for (const char c : line)
      if (c != ' ' && c != '\t' && c != '\r') packed += c;
    if (packed.empty() || packed.front() == '#') continue;
    std::istringstream cells(packed);
    for (std::string cell; std::getline(cells, cell, ',');) header.names.push_back(cell);
    break;
  }
  return header;
}

/// Index in all_columns() of each column of the file.
std::vector<std::size_t> columns_of(const Header& header, const std::string& source) {
  const std::string line = "line " + std::to_string(header.line);
  std::vector<std::string> known;
  for (const TableColumn& column : all_columns()) known.emplace_back(column.name);
  std::vector<std::size_t> columns;
  for (const std::string& name : header.names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      const std::string nearest = input::nearest_name(name, known);
      input::refuse_value(
          source,
          line,
          name,
          "is not a column of a path (strain_xx to strain_zx, stress_xx to stress_zx, "
          "pore_pressure and time are); " +
              (nearest.empty() ? "correct its name" : "did you mean '" + nearest + "'?")
      );
    }
    columns.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  if (columns.empty() || columns.front() != time_column) {
    input::refuse_value(
        source, line, header.names.front(), "is the first column of a path; begin with time"
    );
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (std::find(columns.begin(), columns.begin() + static_cast<long>(i), columns[i]) ==
        columns.begin() + static_cast<long>(i))
      continue;
    input::refuse_value(
        source,
        line,
        header.names[i],
        "is there twice (every column has its own name); take one of them out"
    );
  }
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
    const TableRows& table,
    const std::vector<std::size_t>& columns,
    std::size_t row,
    const std::string& source
) {
  MixedRow out;
  out.line = table.lines[row];
  std::array<bool, 6> taken{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double value = table.values[row * columns.size() + i];
    if (std::isnan(value)) continue;  // an empty cell
    if (columns[i] == time_column) {
      out.time = value;
    } else if (columns[i] == pore_pressure_column) {
      out.pore_pressure = value;
      out.drained = true;
    } else {
      take_cell(out, taken, columns[i], source);
      out.target[columns[i] % 6] = value;
    }
  }
  check_taken(out, taken, columns, source);
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

bool is_mixed_path(const std::string& text) {
  const Header header = header_of(text);
  return std::any_of(header.names.begin(), header.names.end(), [](const std::string& name) {
    return name.rfind("stress", 0) == 0 || name.rfind("strain", 0) == 0 ||
           name.rfind("pore", 0) == 0;
  });
}

MixedPath read_mixed_path(const std::string& text, const std::string& source) {
  const std::vector<std::size_t> columns = columns_of(header_of(text), source);
  std::vector<TableColumn> asked;
  asked.reserve(columns.size());
  for (const std::size_t c : columns) asked.push_back(all_columns()[c]);
  const TableRows table = read_table(text, asked, "a path", source);
  check_row_count(table.lines.size(), source);
  MixedPath path;
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
