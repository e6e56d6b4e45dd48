// SPDX-License-Identifier: BSD-3-Clause
#include "drive/path_table.hpp"

#include "deck/files/read_table.hpp"
#include "drive/matrix.hpp"

#include <barreno/input/scan_xml.hpp>

namespace barreno {
namespace {

using input::exact_text;

const std::vector<TableColumn>& columns() {
  static const std::vector<TableColumn> all = [] {
    std::vector<TableColumn> list = {{"time", dimension::time}};
    for (const char* name : {"F11", "F12", "F13", "F21", "F22", "F23", "F31", "F32", "F33"})
      list.push_back({name, dimension::none});
    return list;
  }();
  return all;
}

std::string line_of(const PathRow& row) {
  return "line " + std::to_string(row.line);
}

PathRow row_of(const TableRows& table, std::size_t index) {
  const double* cells = table.values.data() + index * columns().size();
  PathRow row;
  row.time = cells[0];
  row.line = table.lines[index];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) row.deformation_gradient(i, j) = cells[1 + 3 * i + j];
  return row;
}

void check_volume(const PathRow& row, const std::string& source) {
  const double volume = determinant(row.deformation_gradient);
  if (volume > 0.0) return;
  input::refuse(
      source,
      line_of(row),
      "has det F = " + exact_text(volume) +
          " (volumes are positive); correct F11 to F33 of that row"
  );
}

}  // namespace

void check_row_count(std::size_t count, const std::string& source) {
  if (count >= 2) return;
  input::refuse(
      source,
      "too few rows: " + std::to_string(count),
      "below the header (a path leads from one instant to another); give at least two"
  );
}

void check_times(double before, int line_before, double time, int line, const std::string& source) {
  if (time > before) return;
  input::refuse_value(
      source,
      "line " + std::to_string(line) + ", time",
      exact_text(time),
      "is not after " + exact_text(before) + " of line " + std::to_string(line_before) +
          " (times must increase); sort the rows or correct the time"
  );
}

std::vector<PathRow> read_path(
    const std::string& text, const std::string& source, std::vector<std::string>* notes
) {
  const TableRows table = read_table(text, columns(), "a path", source);
  if (notes != nullptr) *notes = table.notes;
  check_row_count(table.lines.size(), source);
  std::vector<PathRow> path;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const PathRow row = row_of(table, i);
    if (!path.empty()) check_times(path.back().time, path.back().line, row.time, row.line, source);
    check_volume(row, source);
    path.push_back(row);
  }
  return path;
}

}  // namespace barreno
