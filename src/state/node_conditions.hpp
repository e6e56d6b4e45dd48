// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "scene/time_tables.hpp"

#include <vector>

namespace barreno {

/// A condition on the nodes at and behind a face of the grid: components of the velocity that it
/// sets, and to what.
struct NodeCondition {
  int axis = 0;
  int bound =
      0;  ///< on the lattice of level 0: nodes <= bound (lower face) or >= bound (upper face)
  bool lower = true;
  bool sets[3] = {false, false, false};
  double velocity[3] = {0.0, 0.0, 0.0};  ///< times the factor of its table [length/time]
  int table = -1;                        ///< of NodeConditions::factors; -1: no motion

  /// @param level  of the lattice that the node is counted on
  KOKKOS_INLINE_FUNCTION bool holds(const int (&node)[3], int level) const {
    return lower ? node[axis] <= bound << level : node[axis] >= bound << level;
  }
  /// It moves nodes, or sets their axial velocity: then it gives work or axial momentum, which
  /// change with the step. What only stops a component across y gives neither.
  KOKKOS_INLINE_FUNCTION bool gives() const { return table >= 0 || sets[1]; }
};

/// One on each face, and that of the axis of revolution.
constexpr int max_conditions = 7;

/// Velocities that conditions set over the step of one tile: before it, and after it.
struct PrescribedVelocities {
  double before[max_conditions][3] = {};
  double after[max_conditions][3] = {};
};

/// The conditions of a scene as kernels read them.
struct NodeConditions {
  int count = 0;
  NodeCondition list[max_conditions];
  TimeTables factors;
  double time = 0.0;     ///< at the start of the step
  double last_dt = 0.0;  ///< of the step before it

  /// Of a step of `dt`. Velocities of the scheme belong to the middles of steps: so a path is
  /// followed exactly where it is a parabola.
  KOKKOS_INLINE_FUNCTION PrescribedVelocities over_step(double dt) const {
    PrescribedVelocities out;
    for (int i = 0; i < count; ++i) {
      const NodeCondition& c = list[i];
      if (c.table < 0) continue;
      const double before = factors(c.table, time - 0.5 * last_dt);
      const double after = factors(c.table, time + 0.5 * dt);
      for (int d = 0; d < 3; ++d) {
        out.before[i][d] = c.velocity[d] * before;
        out.after[i][d] = c.velocity[d] * after;
      }
    }
    return out;
  }
};

/// The axis of revolution is a symmetry condition that no deck needs to ask for.
NodeConditions make_node_conditions(const std::vector<ConditionSpec>& conditions, const Grid& grid);

}  // namespace barreno
