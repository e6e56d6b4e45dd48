// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// The scene's conditions in the step from a clock on.
inline NodeConditions conditions_of_step(const NodeConditions& of_scene, const Clock& clock) {
  NodeConditions out = of_scene;
  out.time = clock.time;
  out.last_dt = clock.dt;
  return out;
}

/// The same nodes and components, set to zero: what a correction of velocities must keep.
inline NodeConditions homogeneous(const NodeConditions& conditions) {
  NodeConditions out = conditions;
  for (NodeCondition& condition : out.list) condition.table = -1;
  return out;
}

/// Where a node is on the box's lattice of a level.
struct NodePlace {
  int index[3];
  int level;
};

/// A node's velocity before and after the step.
template <unsigned D>
struct NodeVelocity {
  double before[D], after[D];
};

/// What moves a node over the step.
template <unsigned D>
struct NodeForces {
  double dt, mass;
  const double (&force)[D];  ///< of all that act, contact included
};

/// What conditions do to the material at a node.
struct ConditionTally {
  double work = 0.0;            ///< [energy]
  double axial_impulse = 0.0;   ///< of the reaction
  double axial_of_start = 0.0;  ///< momentum that they changed in v^n
};

/// Velocities that the faces of the grid set at a node: a symmetry plane and the axis of revolution
/// stop the component across them, a fixed face stops all, a moving one imposes its own.
/// docs/method.md (2.5)
///
///   v_i = V_i(t - dt_old / 2),   v_i' = V_i(t + dt / 2)   for the components i that are set
///
/// with V = 0 at planes and fixed faces. The reaction m (v' - v) - f dt is the impulse on the
/// material. (Nodes behind a symmetry plane get the mirrored velocity: mirror_nodes.hpp.)
///
/// @param velocities  of this tile's step (NodeConditions::over_step)
/// @return whether a condition gives work or axial momentum at the node (NodeCondition::gives)
template <unsigned D>
KOKKOS_INLINE_FUNCTION bool prescribe_velocities(
    const NodeConditions& conditions,
    const PrescribedVelocities& velocities,
    const NodePlace& node,
    const NodeForces<D>& forces,
    NodeVelocity<D>& v,
    ConditionTally& tally
) {
  const double raw = v.before[1];
  bool set[D] = {};
  bool gives = false;
  for (int i = 0; i < conditions.count; ++i) {
    const NodeCondition& c = conditions.list[i];
    if (!c.holds(node.index, node.level)) continue;
    gives = gives || c.gives();
    for (unsigned d = 0; d < D; ++d) {
      if (!c.sets[d]) continue;
      v.before[d] = velocities.before[i][d];
      v.after[d] = velocities.after[i][d];
      set[d] = true;
    }
  }
  for (unsigned d = 0; d < D; ++d) {
    if (!set[d]) continue;
    const double reaction = forces.mass * (v.after[d] - v.before[d]) - forces.force[d] * forces.dt;
    tally.work += 0.5 * reaction * (v.before[d] + v.after[d]);
    if (d == 1) tally.axial_impulse += reaction;
  }
  if (set[1]) tally.axial_of_start += forces.mass * (v.before[1] - raw);
  return gives;
}

}  // namespace barreno
