// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/grid_share.hpp"
#include "step/nodes/node_scales.hpp"

namespace barreno {

/// What rigid bodies gave to the material over the step, this rank's nodes, each counted once.
struct RigidTally {
  ReproducibleSum work;             ///< impulses on the material times velocities of the bodies
  ReproducibleSum tangential_work;  ///< the same of the parts along surfaces
  RigidImpulses reaction{};         ///< what the bodies got, by State::reactions
};
KOKKOS_INLINE_FUNCTION void add(const RigidTally& part, RigidTally& sum) {
  sum.work += part.work;
  sum.tangential_work += part.tangential_work;
  for (std::size_t r = 0; r < max_velocity_fields; ++r)
    for (std::size_t d = 0; d < 3; ++d) sum.reaction[r][d] += part.reaction[r][d];
}

/// What contact needs to know of the step, beside what meets at the nodes.
struct ContactStep {
  double time;     ///< at its start, for the motion of rigid bodies
  double damping;  ///< of the step, or 0 where the sums hold no forces [1/time]
  GridShare grid_share;
  NodeScaleRule scales;
};

/// What the velocity fields do to each other at the nodes that they share. docs/method.md 6
///
///   v_a += m v_b / (m_a + m_b) ... of contact_impulse(), first on v^n, then on v^n + dt f / (m +
///   dt Z)
///
/// The pairs take their turns; three fields and more at a node repeat them, each pair with what the
/// others left. Momentum is kept by every pair. What changes v^n is seen by the particles only
/// through the velocity that they move with, and by the share of it that PIC gives them; the
/// impulse of the second joins the forces. Both count as reactions of rigid bodies as far as
/// particles feel them.
///
/// @pre  detect_contact_nodes, fit_surface_normals, refine_surface_normals
/// @post Nodes::impulse of all fields, in shared tiles
RigidTally solve_contact(
    const Grid& grid,
    const VelocityFields& fields,
    const RigidMotions& motions,
    const ContactStep& step,
    const ContactNodes& contact,
    const std::vector<Nodes>& nodes
);

}  // namespace barreno
