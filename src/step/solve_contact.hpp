// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// What rigid bodies gave to the material over the step, this rank's nodes, each counted once.
struct RigidTally {
  WholeSum work;             ///< impulses on the material times velocities of the bodies
  WholeSum tangential_work;  ///< the same of the parts along surfaces
  RigidImpulses reaction{};  ///< what the bodies got, by State::reactions
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
/// @pre  share_nodes, fit_normals, seek_normals
/// @param clock  at the start of the step, for the motion of rigid bodies
/// @param damping  of the step, or 0 where the sums hold no forces [1/time]
/// @post Nodes::impulse of all fields, in shared tiles
RigidTally solve_contact(
    const Scene& scene, const Clock& clock, double dt, double damping, State& state
);

}  // namespace barreno
