// SPDX-License-Identifier: BSD-3-Clause
#include "deck/jet_table.hpp"

#include "base/error.hpp"

#include <array>
#include <barreno/input/scan_xml.hpp>
#include <sstream>
#include <vector>

namespace barreno {
namespace {

using input::refuse;
using input::refuse_value;

struct Column {
  const char* name = "";
  Dimension dimension;
};
constexpr std::array<Column, 5> columns = {
    {{"time", dimension::time},
     {"velocity", dimension::velocity},
     {"radius", dimension::length},
     {"length", dimension::length},
     {"density", dimension::density}}};
constexpr const char* header = "time,velocity,radius,length,density";

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
    std::vector<double>& values
) {
  const auto cells = cells_of(line);
  if (cells.size() != columns.size()) {
    refuse(
        source,
        where,
        "has " + std::to_string(cells.size()) + " values (" + std::to_string(columns.size()) +
            " belong there); write a row as " + header
    );
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    try {
      values.push_back(input::read_quantity(cells[i], columns[i].dimension, units));
    } catch (const InputError& error) {
      refuse_value(source, where + ", " + columns[i].name, cells[i], error.what());
    }
  }
}

}  // namespace

Teuchos::TwoDArray<double> read_jet_table(const std::string& text, const std::string& source) {
  std::istringstream stream(text);
  std::vector<double> values;
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
        refuse_value(
            source,
            where,
            line,
            "is not the header of a jet table (columns go by it); write \"" + std::string(header) +
                "\""
        );
      }
      header_read = true;
    } else {
      read_row(line, where, source, units, values);
    }
  }
  if (values.empty()) {
    refuse(
        source,
        "",
        "holds no slug (a jet needs at least one row below the header); add rows or remove Jet"
    );
  }
  using Index = Teuchos::TwoDArray<double>::size_type;
  const auto count = static_cast<Index>(columns.size());
  Teuchos::TwoDArray<double> table(static_cast<Index>(values.size()) / count, count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    table(static_cast<Index>(i) / count, static_cast<Index>(i) % count) = values[i];
  }
  return table;
}

}  // namespace barreno
