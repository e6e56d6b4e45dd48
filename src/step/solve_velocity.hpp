// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/dormancy.hpp"
#include "step/node_conditions.hpp"

namespace barreno {

/// Kinetic energy and momentum on the grid over one step, this rank's nodes, each counted once.
struct GridTally {
  WholeSum kinetic_before;  ///< after conditions were put on v^n
  WholeSum kinetic_after;
  WholeSum force_work;         ///< sum f . v_mean dt, all nodes
  WholeSum condition_work;     ///< of the conditions on the material
  WholeSum condition_impulse;  ///< axial, of the conditions on the material
  WholeSum filter_impulse;     ///< axial, what the conditions changed in v^n
  WholeSum taken_impulse;    ///< what of it reaches particles: by PIC only, the grid's share of it
  WholeSum damped;           ///< work done against the damping, part of force_work
  WholeSum damping_impulse;  ///< axial, of the damping
  WholeSum absorbed;  ///< work of the impedances on the change of velocity, part of force_work
  WholeSum absorbed_impulse;  ///< axial, of the same
  WholeSum contact_work;      ///< impulses of contact times mean velocity
  WholeSum tangential_work;   ///< the same of their parts along surfaces
};

/// Tiles whose nodes are not solved by their sums alone.
struct SpecialTiles {
  ArrayView<unsigned char>
      shared;         ///< ContactNodes::shared_tile: there nodes.impulse joins the forces
  Dormancy dormancy;  ///< tiles at rest whose nodes stay still are not solved, and count nothing
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
/// @post nodes.motion holds v' and v' - v, but of tiles that stay still; Dormancy::still says which
/// tiles at rest are; the sums are left as they were, so that a step can be
/// retried
GridTally solve_velocity(
    const Scene& scene,
    const Grid& grid,
    const NodeConditions& conditions,
    double dt,
    double damping,
    const SpecialTiles& special,
    Nodes& nodes
);

}  // namespace barreno
