// SPDX-License-Identifier: BSD-3-Clause
#include "scene/time_tables.hpp"

#include "base/view_of.hpp"

namespace barreno {

TimeTables make_time_tables(const std::vector<Table>& tables) {
  std::vector<int> first{0};
  std::vector<double> time, value;
  for (const Table& table : tables) {
    time.insert(time.end(), table.time.begin(), table.time.end());
    value.insert(value.end(), table.value.begin(), table.value.end());
    first.push_back(static_cast<int>(time.size()));
  }
  return {view_of("first_entry", first), view_of("times", time), view_of("values", value)};
}

}  // namespace barreno
