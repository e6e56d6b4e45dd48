// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/read_table.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <limits>

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

std::string where_of(int line) {
  return "line " + std::to_string(line);
}

/// The system of the plain numbers of all rows.
input::UnitSystem system_of(const TableText& table, const std::string& source) {
  input::UnitSystem units;
  const TableComment* found = nullptr;
  for (const TableComment& comment : table.comments) {
    if (comment.key != "units") continue;
    const std::string where = where_of(comment.line) + ", units";
    if (found != nullptr && found->value != comment.value)
      refuse_value(
          source, where, comment.value, "is another system than above; keep one for all rows"
      );
    found = &comment;
    try {
      units = input::read_unit_system(comment.value);
    } catch (const InputError& error) {
      refuse_value(source, where, comment.value, error.what());
    }
  }
  return units;
}

/// A ratio in percent or the like.
double read_ratio(const std::string& cell) {
  const std::size_t end = cell.find_first_not_of("0123456789+-.eE ");
  const auto scale = end == std::string::npos ? std::nullopt : scale_of_ratio(cell.substr(end));
  if (!scale) return input::read_quantity(cell, dimension::none, {});
  const double value = input::read_quantity(cell.substr(0, end), dimension::none, {});
  return input::to_si(value, {1.0, *scale, dimension::none});
}

double read_cell(
    const std::string& cell,
    const std::string& unit,
    const Dimension& dimension,
    const input::UnitSystem& units
) {
  const bool plain = cell.find_first_not_of("0123456789+-.eE") == std::string::npos;
  const bool unitless = unit.empty() || unit == "-" || unit == "1";
  const std::string full = plain && !unitless && !cell.empty() ? cell + " " + unit : cell;
  return dimension == dimension::none ? read_ratio(full)
                                      : input::read_quantity(full, dimension, units);
}

void check_width(
    const TableLine& row, const std::vector<TableColumn>& columns, const std::string& source
) {
  const std::size_t found = row.cells.size(), wanted = columns.size();
  if (found == wanted) return;
  const char* const commas =
      found == 2 * wanted ? " (decimal commas? then separate the cells by semicolons)" : "";
  refuse(
      source,
      where_of(row.number),
      "has " + std::to_string(found) + " values (" + std::to_string(wanted) +
          " are expected); write a row as " + header_of(columns) + commas
  );
}

}  // namespace

TableRows read_rows(
    const TableText& table, const std::vector<TableColumn>& columns, const std::string& source
) {
  const input::UnitSystem units = system_of(table, source);
  TableRows rows;
  rows.notes = table.notes;
  for (const TableLine& row : table.rows) {
    check_width(row, columns, source);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].may_be_empty && row.cells[i].empty()) {
        rows.values.push_back(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      try {
        rows.values.push_back(read_cell(row.cells[i], table.units[i], columns[i].dimension, units));
      } catch (const InputError& error) {
        const std::string where = where_of(row.number) + ", " + columns[i].name;
        refuse_value(source, where, row.cells[i], error.what());
      }
    }
    rows.lines.push_back(row.number);
  }
  return rows;
}

TableRows read_table(
    const std::string& text,
    const std::vector<TableColumn>& columns,
    const std::string& what,
    const std::string& source
) {
  std::vector<std::string> known;
  known.reserve(columns.size());
  for (const TableColumn& column : columns) known.emplace_back(column.name);
  const TableText table = split_table(text, known, source);
  if (table.header_line == 0) {
    system_of(table, source);
    return {};
  }
  std::vector<std::size_t> place;  // of each column of the file in the answer
  for (const std::string& name : table.names)
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (lower_case(columns[i].name) == name) place.push_back(i);
  std::vector<std::size_t> sorted = place;
  std::sort(sorted.begin(), sorted.end());
  const bool each_once = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  if (place.size() != columns.size() || table.names.size() != columns.size() || !each_once)
    refuse_value(
        source,
        where_of(table.header_line),
        table.header,
        "is not the header of " + what + " (the header identifies the columns); write \"" +
            header_of(columns) + "\""
    );
  std::vector<TableColumn> in_file;
  in_file.reserve(place.size());
  for (const std::size_t i : place) in_file.push_back(columns[i]);
  TableRows rows = read_rows(table, in_file, source);
  const std::vector<double> values = rows.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t width = columns.size();
    rows.values[i / width * width + place[i % width]] = values[i];
  }
  return rows;
}

}  // namespace barreno
