// SPDX-License-Identifier: BSD-3-Clause
#include "files/measured_table.hpp"

#include "files/installed_file.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

namespace barreno {
namespace {

namespace fs = std::filesystem;

constexpr InstalledFolders measured_folders{
    BARRENO_MEASURED_IN_PREFIX, BARRENO_MEASURED_FOLDER, BARRENO_INSTALLED_MEASURED_FOLDER};

/// The whole of a text as a finite number.
std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return {};
  return value;
}

/// A row from its right end: the numbers, and in front of them the name.
std::optional<MeasuredTable::Row> row_in(std::string line, std::size_t count) {
  MeasuredTable::Row row;
  row.numbers.resize(count);
  for (std::size_t n = count; n-- > 0;) {
    const std::size_t comma = line.rfind(',');
    if (comma == std::string::npos) return {};
    const std::optional<double> value = number_in(line.substr(comma + 1));
    if (!value) return {};
    row.numbers[n] = *value;
    line.resize(comma);
  }
  if (line.empty()) return {};
  row.name = line;
  return row;
}

std::string header_of(const std::vector<std::string>& columns) {
  std::string header;
  for (const std::string& column : columns) header += (header.empty() ? "" : ",") + column;
  return header;
}

/// Why a text is no such table, for a sentence; empty if it is one.
std::string read_rows(
    std::istream& text,
    const std::vector<std::string>& columns,
    std::vector<MeasuredTable::Row>& rows
) {
  const std::string header = header_of(columns);
  bool has_header = false;
  std::string last;
  int number = 0;
  for (std::string line; std::getline(text, line); last = line) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (!has_header) {
      if (line != header) return "line " + std::to_string(number) + " is not \"" + header + "\"";
      has_header = true;
      continue;
    }
    std::optional<MeasuredTable::Row> row = row_in(line, columns.size() - 1);
    if (!row) return "line " + std::to_string(number) + " is no row of " + header;
    rows.push_back(std::move(*row));
  }
  const std::string end = "# end of " + std::to_string(rows.size()) + " rows";
  if (last != end) return "it does not end with \"" + end + "\": rows are missing";
  return {};
}

}  // namespace

MeasuredTable read_measured(
    const std::string& name, const std::vector<std::string>& columns, const fs::path& folder
) {
  MeasuredTable table;
  const fs::path path = folder.empty() ? installed_file(measured_folders, name) : folder / name;
  std::ifstream text(path);
  if (path.empty() || !text)
    table.problem = "the measured numbers of " + name + " are not installed";
  else if (const std::string why = read_rows(text, columns, table.rows); !why.empty())
    table.problem = "the measured numbers of '" + path.string() + "' cannot be used: " + why;
  if (!table.problem.empty()) table.rows.clear();
  return table;
}

}  // namespace barreno
