// SPDX-License-Identifier: BSD-3-Clause
#include "step/node_conditions.hpp"

namespace barreno {

// The axis of revolution is a symmetry condition that no deck needs to ask for. Velocities of the
// scheme belong to the middles of steps: so a path is followed exactly where it is a parabola.
NodeConditions node_conditions(
    const Scene& scene, const Grid& grid, const Clock& clock, double dt
) {
  NodeConditions out;
  if (scene.grid.mode == Mode::axisymmetric && grid.lower[0] == 0.0) {
    NodeCondition& axis = out.list[out.count++];
    axis.sets[0] = true;
  }
  for (const ConditionSpec& spec : scene.conditions) {
    NodeCondition& c = out.list[out.count++];
    const int face = static_cast<int>(spec.face);
    c.axis = face / 2;
    c.lower = face % 2 == 0;
    c.bound = c.lower ? 0 : grid.cells[c.axis];
    for (int d = 0; d < grid.patch.dimensions; ++d) {
      c.sets[d] = spec.kind != ConditionKind::symmetry || d == c.axis;
      if (spec.kind != ConditionKind::prescribed_velocity) continue;
      const double velocity = spec.velocity[static_cast<std::size_t>(d)];
      c.before[d] = velocity * spec.factor(clock.time - 0.5 * clock.dt);
      c.after[d] = velocity * spec.factor(clock.time + 0.5 * dt);
    }
  }
  return out;
}

NodeConditions at_rest(NodeConditions conditions) {
  for (NodeCondition& condition : conditions.list)
    for (int d = 0; d < 3; ++d) condition.before[d] = condition.after[d] = 0.0;
  return conditions;
}

}  // namespace barreno
