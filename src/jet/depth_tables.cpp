// SPDX-License-Identifier: BSD-3-Clause
#include "jet/depth_tables.hpp"

#include "files/measured_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace barreno {
namespace {

constexpr const char* own_slugs = "as in the table";

using Rows = std::vector<MeasuredTable::Row>;

/// Where a value is in a list, or the list's size.
std::size_t place_of(const std::vector<double>& list, double value) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin());
}

std::vector<double> sorted(const Rows& rows, const std::string& name, std::size_t column) {
  std::vector<double> values;
  for (const MeasuredTable::Row& row : rows)
    if (name.empty() || row.name == name) values.push_back(row.numbers[column]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

bool all_positive(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return x > 0.0; });
}

/// Rows of name, cell, time, depth.
std::string take_depths(const Rows& rows, DepthTables& tables) {
  tables.times = sorted(rows, "run", 1);
  std::vector<double> cells = sorted(rows, "run", 0);
  std::reverse(cells.begin(), cells.end());
  const std::size_t count = tables.times.size();
  for (const double cell : cells) tables.depths.push_back({cell, std::vector<double>(count)});
  tables.estimated.resize(count);
  tables.finest.resize(count);
  for (const MeasuredTable::Row& row : rows) {
    const std::size_t time = place_of(tables.times, row.numbers[1]);
    if (time == count) return "a depth is of a time that no run has";
    if (row.name != "run" && row.name != "finest" && row.name != "estimate")
      return "nothing is known of rows \"" + row.name + "\"";
    if (row.name == "estimate") tables.estimated[time] = row.numbers[2];
    if (row.name == "finest") tables.finest[time] = row.numbers[2];
    if (row.name == "run")
      tables.depths[place_of(cells, row.numbers[0])].depth[time] = row.numbers[2];
  }
  if (tables.depths.size() < 2) return "there are depths with less than two sizes of cells";
  if (!all_positive(tables.depths.back().depth))
    return "the smallest cells have no depth at one of the times";
  if (!all_positive(tables.estimated)) return "one of the times has no estimate";
  if (sorted(rows, "finest", 0).empty()) return "there is no depth with half the smallest cells";
  return {};
}

/// Rows of name, cells per radius, low, high.
std::string take_steady(const Rows& rows, DepthTables& tables) {
  for (const MeasuredTable::Row& row : rows)
    tables.steady.push_back({row.numbers[0], row.numbers[1], row.numbers[2]});
  bool fits = tables.steady.size() == tables.depths.size();
  constexpr double round_off = 1e-9;
  for (std::size_t i = 0; fits && i < tables.steady.size(); ++i)
    fits = std::abs(
               tables.steady[i].cells_per_radius * tables.depths[i].cell / measured_radius - 1.0
           ) < round_off;
  return fits ? "" : "its cells are not those of the depths";
}

/// Rows of slugs, length over radius, cells per radius, error.
std::string take_lengths(const Rows& rows, DepthTables& tables) {
  const std::vector<double> lengths = sorted(rows, "", 0), cells = sorted(rows, "", 1);
  const std::vector<double> own = sorted(rows, own_slugs, 0);
  if (cells.size() != 2 || lengths.size() < 2 || rows.size() != 2 * lengths.size())
    return "it has not two errors for each of several lengths";
  const auto is_own = [](const MeasuredTable::Row& row) { return row.name == own_slugs; };
  if (own.size() != 1 || std::count_if(rows.begin(), rows.end(), is_own) != 2)
    return "it has no two rows of slugs \"" + std::string(own_slugs) + "\"";
  tables.own_length = place_of(lengths, own.front());
  tables.length_cells = {cells[0], cells[1]};
  std::vector<int> found(rows.size());
  for (const double length : lengths) tables.lengths.push_back({length, {}});
  for (const MeasuredTable::Row& row : rows) {
    const std::size_t length = place_of(lengths, row.numbers[0]);
    const std::size_t cell = place_of(cells, row.numbers[1]);
    tables.lengths[length].error[cell] = row.numbers[2];
    ++found[2 * length + cell];
  }
  if (std::any_of(found.begin(), found.end(), [](int n) { return n != 1; }))
    return "it has an error twice";
  return {};
}

/// Whose error a row is: the depth first, then the others with the same cells.
constexpr std::pair<std::string_view, DepthError DividedError::*> divided_rows[] = {
    {"depth", &DividedError::depth},
    {"depth at rest", &DividedError::resting},
    {"probed depth", &DividedError::probed},
    {"volume", &DividedError::volume},
    {"efficiency", &DividedError::efficiency}};

/// Rows of what, cells per radius, value, low, high.
std::string take_divided(const Rows& rows, DepthTables& tables) {
  std::vector<DividedError>& found = tables.divided;
  for (const MeasuredTable::Row& row : rows) {
    const double cells = row.numbers[0];
    const DepthError error{row.numbers[1], row.numbers[2], row.numbers[3]};
    if (!(error.low <= error.value && error.value <= error.high))
      return "an error is outside of its range";
    const auto* const whose =
        std::find_if(std::begin(divided_rows), std::end(divided_rows), [&](const auto& one) {
          return one.first == row.name;
        });
    if (whose == std::end(divided_rows)) return "nothing is known of rows \"" + row.name + "\"";
    if (whose == std::begin(divided_rows)) found.push_back({cells, {}, {}, {}, {}, {}});
    if (found.empty() || found.back().cells_per_radius != cells)
      return "a " + row.name + " does not follow the depth with the same cells";
    found.back().*(whose->second) = error;
  }
  const auto fewer = [](const DividedError& a, const DividedError& b) {
    return a.cells_per_radius < b.cells_per_radius;
  };
  if (found.size() < 2 || rows.size() != std::size(divided_rows) * found.size())
    return "it has not five errors for each of several sizes of cells";
  return std::is_sorted(found.begin(), found.end(), fewer) ? "" : "its cells are not sorted";
}

}  // namespace

DepthTables read_depth_tables(const std::filesystem::path& folder) {
  struct File {
    const char* name;
    std::vector<std::string> columns;
    std::string (*take)(const Rows&, DepthTables&);
  };
  const File files[] = {
      {"depths_of_cells.csv", {"what", "cell", "time", "depth"}, take_depths},
      {"steady_errors.csv", {"target", "cells_per_radius", "low", "high"}, take_steady},
      {"length_errors.csv",
       {"slugs", "length_over_radius", "cells_per_radius", "error"},
       take_lengths},
      {"divided_errors.csv", {"what", "cells_per_radius", "value", "low", "high"}, take_divided}};
  DepthTables tables;
  for (const File& file : files) {
    const MeasuredTable table = read_measured(file.name, file.columns, folder);
    std::string problem = table.problem;
    if (problem.empty()) {
      const std::string why = file.take(table.rows, tables);
      if (!why.empty())
        problem = "the measured numbers of " + std::string(file.name) + " cannot be used: " + why;
    }
    if (problem.empty()) continue;
    tables = {};
    tables.problem = problem;
    return tables;
  }
  return tables;
}

const DepthTables& depth_tables() {
  static const DepthTables tables = read_depth_tables();
  return tables;
}

}  // namespace barreno
