// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/dormancy.hpp"
#include "state/subcycling.hpp"
#include "step/boundary/prescribe_velocities.hpp"
#include "step/grid_share.hpp"
#include "step/grid_tally.hpp"
#include "step/nodes/node_scales.hpp"

namespace barreno {

/// What the velocity of a node follows from beside its sums.
struct VelocityRule {
  NodeConditions conditions;  ///< of this step (node_conditions)
  double damping;             ///< of the step, or 0 where the sums hold no forces [1/time]
  GridShare grid_share;
  NodeScaleRule scales;

  /// @param of_step  conditions of the step (node_conditions, homogeneous)
  VelocityRule(const Scene& scene, const NodeConditions& of_step, double of_damping)
      : conditions(of_step),
        damping(of_damping),
        grid_share(scene.step),
        scales(scene.materials, scene.grid) {}
};

/// Tiles whose nodes are not solved by their sums alone.
struct SpecialTiles {
  ArrayView<unsigned char>
      shared;  ///< ContactNodes::shared_tile: there nodes.impulse joins the forces
  ArrayView<unsigned char> passes_up;  ///< ContactNodes::passes_up: some follow where they meet
  Dormancy dormancy;                   ///< nodes of dormant tiles are not solved, and count nothing
  bool first_field = true;             ///< of those that are solved (DormantNodes)
  Subcycling subcycling;
};

/// Add the overlapping parts of neighbouring patches and solve for the velocity of every node, in
/// one pass over the tiles. docs/method.md (2.5)
///
///   v_I = p_I / m_I,   v_I' = v_I + dt (f_I - damping p_I) / (m_I + dt Z_I),   conditions replace
///   components of both (prescribe_velocities)
///
/// With Subcycling dt is the length of a node's own step, and nodes are solved with the part that
/// ends it (find_node_periods).
///
/// Every tile does this for its whole patch, in one order of the parts, so that copies of a node
/// agree to the last bit and no second exchange is needed.
///
/// @pre  sums hold each tile's own part, ghosts included (exchange_halo)
/// @post nodes.motion holds v' and v' - v of nodes that are solved, but of tiles that stay
/// motionless; Dormancy::motionless says which; the sums are left as they were, so that a step can
/// be retried
GridTally solve_velocity(
    const Grid& grid, const VelocityRule& rule, const SpecialTiles& special, Nodes& nodes
);

}  // namespace barreno
