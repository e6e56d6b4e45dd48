// SPDX-License-Identifier: BSD-3-Clause
#include "step/boundary/prescribe_velocities.hpp"

namespace barreno {

NodeConditions conditions_of_step(const NodeConditions& of_scene, const Clock& clock) {
  NodeConditions out = of_scene;
  out.time = clock.time;
  out.last_dt = clock.dt;
  return out;
}

NodeConditions homogeneous(const NodeConditions& conditions) {
  NodeConditions out = conditions;
  for (NodeCondition& condition : out.list) condition.table = -1;
  return out;
}

}  // namespace barreno
