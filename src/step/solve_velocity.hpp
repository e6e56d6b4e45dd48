// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/node_conditions.hpp"

namespace barreno {

/// Kinetic energy and momentum on the grid over one step, this rank's nodes, each counted once.
struct GridTally {
  double kinetic_before = 0.0;  ///< after conditions were put on v^n
  double kinetic_after = 0.0;
  double force_work = 0.0;         ///< sum f . v_mean dt, all nodes
  double condition_work = 0.0;     ///< of the conditions on the material
  double condition_impulse = 0.0;  ///< axial, of the conditions on the material
  double filter_impulse =
      0.0;  ///< axial, what the conditions changed in v^n (reaches particles by PIC only)
  double damped = 0.0;           ///< work done against the damping, part of force_work
  double damping_impulse = 0.0;  ///< axial, of the damping
  double absorbed = 0.0;  ///< work of the impedances on the change of velocity, part of force_work
  double absorbed_impulse = 0.0;  ///< axial, of the same
  double contact_work = 0.0;      ///< impulses of contact times mean velocity
  double tangential_work = 0.0;   ///< the same of their parts along surfaces
};

/// Add the overlapping parts of neighbouring patches and solve for the velocity of every node, in
/// one pass over the tiles. docs/method.md (2.5)
///
///   v_I = p_I / m_I,   v_I' = v_I + dt (f_I - damping p_I) / (m_I + dt Z_I),   conditions replace
///   components of both
///
/// Every tile does this for its whole patch, in one order of the parts, so that copies of a node
/// agree to the last bit and no second exchange is needed.
///
/// @pre  sums hold each tile's own part, ghosts included (exchange_halo)
/// @param conditions  of this step (node_conditions)
/// @param damping  of the step, or 0 where the sums hold no forces [1/time]
/// @param contact  tiles in which nodes.impulse joins the forces; none without contact
/// @post nodes.motion holds v' and v' - v; the sums are left as they were, so that a step can be
/// retried
GridTally solve_velocity(
    const Scene& scene,
    const Grid& grid,
    const NodeConditions& conditions,
    double dt,
    double damping,
    const ContactNodes& contact,
    Nodes& nodes
);

}  // namespace barreno
