// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// A condition on the nodes beyond one index of an axis: components that it sets, and to what.
struct NodeCondition {
  int axis = 0;
  int bound = 0;  ///< nodes <= bound (lower face) or >= bound (upper face)
  bool lower = true;
  bool sets[3] = {false, false, false};
  double before[3] = {0.0, 0.0, 0.0};  ///< velocity before the step, and after it
  double after[3] = {0.0, 0.0, 0.0};

  KOKKOS_INLINE_FUNCTION bool holds(const int (&node)[3]) const {
    return lower ? node[axis] <= bound : node[axis] >= bound;
  }
};

constexpr int most_conditions = 7;
struct NodeConditions {
  int count = 0;
  NodeCondition list[most_conditions];
};

/// The scene's conditions over a step of `dt` from a clock on, that of the axis of revolution
/// included.
NodeConditions node_conditions(const Scene& scene, const Grid& grid, const Clock& clock, double dt);

/// The same nodes and components, set to zero: what a correction of velocities must keep.
NodeConditions at_rest(NodeConditions conditions);

}  // namespace barreno
