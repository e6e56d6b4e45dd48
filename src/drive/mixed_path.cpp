// SPDX-License-Identifier: BSD-3-Clause
#include "drive/mixed_path.hpp"

#include "deck/files/read_table.hpp"
#include "drive/path_table.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <sstream>

namespace barreno {
namespace {

using input::exact_text;

/// Every column that such a path may have; the strains first, then the stresses.
const std::vector<TableColumn>& all_columns() {
  static const std::vector<TableColumn> all = {
      {"strain_xx", dimension::none},
      {"strain_yy", dimension::none},
      {"strain_zz", dimension::none},
      {"strain_xy", dimension::none},
      {"strain_yz", dimension::none},
      {"strain_zx", dimension::none},
      {"stress_xx", dimension::stress},
      {"stress_yy", dimension::stress},
      {"stress_zz", dimension::stress},
      {"stress_xy", dimension::stress},
      {"stress_yz", dimension::stress},
      {"stress_zx", dimension::stress},
      {"pore_pressure", dimension::stress},
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
    for (std::size_t j = 0; j < i; ++j) {
      const bool both = columns[i] < 12 && columns[j] < 12 && columns[i] % 6 == columns[j] % 6;
      if (columns[i] != columns[j] && !both) continue;
      input::refuse_value(
          source,
          line,
          header.names[i],
          "prescribes again what " + header.names[j] +
              " prescribes (a component has its strain or its stress); take one column out"
      );
    }
  }
  return columns;
}

MixedRow row_of(const TableRows& table, const std::vector<std::size_t>& columns, std::size_t row) {
  MixedRow out;
  out.target.fill(0.0);
  out.line = table.lines[row];
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double value = table.values[row * columns.size() + i];
    if (columns[i] == time_column)
      out.time = value;
    else if (columns[i] == pore_pressure_column)
      out.pore_pressure = value;
    else
      out.target[columns[i] % 6] = value;
  }
  return out;
}

void check_first(const MixedPath& path, const std::string& source) {
  const MixedRow& first = path.rows.front();
  for (std::size_t c = 0; c < 6; ++c) {
    if (path.by_stress[c] || first.target[c] == 0.0) continue;
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
  for (const std::size_t c : columns) {
    if (c >= 6 && c < pore_pressure_column) path.by_stress[c - 6] = true;
    if (c == pore_pressure_column) path.drained = true;
  }
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const MixedRow row = row_of(table, columns, i);
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
