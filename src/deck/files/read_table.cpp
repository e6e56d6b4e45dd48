// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/read_table.hpp"

#include "base/error.hpp"

#include <barreno/input/scan_xml.hpp>
#include <limits>
#include <sstream>

namespace barreno {
namespace {

using input::refuse;
using input::refuse_value;

std::string header_of(const std::vector<TableColumn>& columns) {
  std::string header;
  for (const TableColumn& column : columns) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  return header;
}

std::string without_blanks(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\r') result += c;
  }
  return result;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

void read_comment(
    const std::string& line,
    const std::string& where,
    const std::string& source,
    input::UnitSystem& units
) {
  const std::string text = without_blanks(line);
  if (text.rfind("#units:", 0) != 0) return;
  const std::string name = text.substr(7);
  try {
    units = input::read_unit_system(name);
  } catch (const InputError& error) {
    refuse_value(source, where + ", units", name, error.what());
  }
}

void read_row(
    const std::string& line,
    const std::string& where,
    const std::string& source,
    const input::UnitSystem& units,
    const std::vector<TableColumn>& columns,
    std::vector<double>& values
) {
  const auto cells = cells_of(line);
  if (cells.size() != columns.size()) {
    refuse(
        source,
        where,
        "has " + std::to_string(cells.size()) + " values (" + std::to_string(columns.size()) +
            " are expected); write a row as " + header_of(columns)
    );
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].may_be_empty && without_blanks(cells[i]).empty()) {
      values.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    try {
      values.push_back(input::read_quantity(cells[i], columns[i].dimension, units));
    } catch (const InputError& error) {
      refuse_value(source, where + ", " + columns[i].name, cells[i], error.what());
    }
  }
}

}  // namespace

TableRows read_table(
    const std::string& text,
    const std::vector<TableColumn>& columns,
    const std::string& what,
    const std::string& source
) {
  const std::string header = header_of(columns);
  const std::string not_a_header = "is not the header of " + what +
                                   " (the header identifies the columns); write \"" + header + "\"";
  if (text.find('\0') != std::string::npos)
    refuse(source, "", "is not text (it holds a zero byte); is it the right file?");
  std::istringstream stream(text);
  TableRows rows;
  input::UnitSystem units;
  bool header_read = false;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string where = "line " + std::to_string(++number);
    const std::string packed = without_blanks(line);
    if (packed.empty()) continue;
    if (packed.front() == '#') {
      read_comment(line, where, source, units);
    } else if (!header_read) {
      if (packed != header) {
        refuse_value(source, where, line, not_a_header);
      }
      header_read = true;
    } else {
      read_row(line, where, source, units, columns, rows.values);
      rows.lines.push_back(number);
    }
  }
  return rows;
}

}  // namespace barreno
