// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/velocity_fields.hpp"
#include "state/effort.hpp"
#include "step/boundary/symmetry_planes.hpp"
#include "step/nodes/solve_velocity.hpp"

namespace barreno {

/// What XPIC reads beside particles and nodes.
struct FilterRule {
  int powers = 0;     ///< m; 0: another transfer
  VelocityRule rule;  ///< homogeneous conditions, no damping
  SymmetryPlanes symmetry;
};

/// What XPIC takes from the particles, this rank's part.
struct FilterTally {
  ReproducibleSum kinetic;            ///< change of their kinetic energy
  ReproducibleSum condition_impulse;  ///< axial, of the conditions on what XPIC leaves
};

/// XPIC(m): the part of the particles' velocities that the grid does not hold is taken away, before
/// they get the increments of the step as in FLIP. docs/method.md (2.10)
///
///   r_1 = v_p - S v_I,   r_k = r_k-1 - S S+ r_k-1,   v_p <- v_p - r_m
///
/// with S+ r = sum_p S_Ip m_p r_p / m_I and v_I before the forces: v_p becomes (1 - (1 - S S+)^m)
/// v_p, m = 1 is PIC and m without end FLIP. Every power of S S+ is one more projection, exchange
/// and interpolation. Nothing to do for other transfers.
///
/// @pre  particles.grid_motion (interpolate_motion); what nodes hold is not needed any more
/// @post nodes hold the last correction
/// Source: C. Hammerquist, J. Nairn, Comput. Methods Appl. Mech. Eng. 318 (2017) 724-738.
FilterTally filter_velocity(
    const FilterRule& filter,
    const Grid& grid,
    const VelocityFields& fields,
    const Dormancy& dormancy,
    std::vector<Nodes>& nodes,
    std::vector<Particles>& sets,
    Effort& effort
);

}  // namespace barreno
