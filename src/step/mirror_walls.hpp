// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/solve_velocity.hpp"

namespace barreno {

/// A symmetry plane is a mirror: particles whose support reaches beyond it meet their own images.
/// docs/method.md (2.5)
///
///   m_I += m_I',   p_I += M p_I',   f_I += M f_I',   then m_I' = p_I' = f_I' = 0
///
/// for every node I' beyond the plane and its image I; M turns the component across the plane
/// round. (Nodes beyond it that are only held still take mass from the body: an error of the first
/// order in the cell size.)
///
/// A tile does this with its own part of the sums, before they are exchanged: whatever it gives
/// beyond a plane, the images are in its own patch.
/// @post nodes.beyond
void fold_walls(const Scene& scene, const Grid& grid, Nodes& nodes);

/// Whether a plane across y mirrors a tile: its sums are no longer those that its particles gave.
bool is_mirrored_along_axis(const Scene& scene, const Grid& grid, int tile);

/// v_I' = M v_I beyond the planes, and what the mirror gives to the axial momentum of the
/// particles.
/// @pre nodes.motion holds the velocities of this step (solve_velocity)
void unfold_walls(const Scene& scene, const Grid& grid, double dt, Nodes& nodes, GridTally& tally);

}  // namespace barreno
