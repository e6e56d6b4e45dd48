// SPDX-License-Identifier: BSD-3-Clause
#include "state/node_conditions.hpp"

namespace barreno {

NodeConditions make_node_conditions(
    const std::vector<ConditionSpec>& conditions, const Grid& grid
) {
  NodeConditions out;
  if (grid.mode == Mode::axisymmetric && grid.lower[0] == 0.0) {
    NodeCondition& axis = out.list[out.count++];
    axis.sets[0] = true;
  }
  std::vector<Table> factors;
  for (const ConditionSpec& spec : conditions) {
    NodeCondition& c = out.list[out.count++];
    const int face = static_cast<int>(spec.face);
    c.axis = face / 2;
    c.lower = face % 2 == 0;
    c.bound = c.lower ? 0 : grid.cells[c.axis];
    for (int d = 0; d < grid.patch.dimensions; ++d)
      c.sets[d] = !traits_of(spec.kind).slides || d == c.axis;
    if (!traits_of(spec.kind).moves) continue;
    for (int d = 0; d < grid.patch.dimensions; ++d)
      c.velocity[d] = spec.velocity[static_cast<std::size_t>(d)];
    c.table = static_cast<int>(factors.size());
    factors.push_back(spec.factor);
  }
  out.factors = make_time_tables(factors);
  return out;
}

}  // namespace barreno
