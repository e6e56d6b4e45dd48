// SPDX-License-Identifier: BSD-3-Clause
#include "check/cost_tables.hpp"

#include "files/measured_table.hpp"

namespace barreno {
namespace {

constexpr const char* updates_name = "update_costs.csv";
constexpr const char* factors_name = "cost_factors.csv";

std::string unusable(const std::string& name, const std::string& why) {
  return "the measured numbers of " + name + " cannot be used: " + why;
}

std::string take_updates(const std::filesystem::path& folder, CostTables& tables) {
  const MeasuredTable table =
      read_measured(updates_name, {"update", "elastic_ns", "running_ns", "early"}, folder);
  for (const MeasuredTable::Row& row : table.rows) {
    const UpdateCost cost{row.numbers[0], row.numbers[1], row.numbers[2] != 0.0};
    if (!(cost.elastic > 0.0) || cost.running < cost.elastic)
      return unusable(updates_name, "\"" + row.name + "\" costs nothing, or less and less");
    if (!tables.updates.emplace(row.name, cost).second)
      return unusable(updates_name, "\"" + row.name + "\" stands there twice");
  }
  return table.problem;
}

std::string take_factors(const std::filesystem::path& folder, CostTables& tables) {
  const MeasuredTable table = read_measured(factors_name, {"factor", "value"}, folder);
  if (!table.problem.empty()) return table.problem;
  const std::map<std::string, double*> wanted{
      {"domains", &tables.domains},
      {"rotations", &tables.rotations},
      {"nodes_of_parts", &tables.nodes_of_parts},
      {"parts_of_flight", &tables.parts_of_flight},
      {"field_nanoseconds", &tables.field_nanoseconds},
      {"row_nanoseconds", &tables.row_nanoseconds}};
  for (const MeasuredTable::Row& row : table.rows) {
    const auto found = wanted.find(row.name);
    if (found != wanted.end()) *found->second = row.numbers[0];
  }
  for (const auto& [name, value] : wanted)
    if (!(*value > 0.0)) return unusable(factors_name, "it has no row " + name + " above 0");
  return {};
}

}  // namespace

CostTables read_cost_tables(const std::filesystem::path& folder) {
  CostTables tables;
  std::string problem = take_updates(folder, tables);
  if (problem.empty()) problem = take_factors(folder, tables);
  if (problem.empty()) return tables;
  tables = {};
  tables.problem = problem;
  return tables;
}

const CostTables& cost_tables() {
  static const CostTables tables = read_cost_tables();
  return tables;
}

}  // namespace barreno
