// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/nodes.hpp"
#include "step/boundary/symmetry_planes.hpp"
#include "step/grid_share.hpp"
#include "step/grid_tally.hpp"

namespace barreno {

/// A symmetry plane is a mirror: particles whose support reaches behind it meet their own images.
/// docs/method.md (2.5)
///
///   m_I += m_I',   p_I += M p_I',   f_I += M f_I',   then m_I' = p_I' = f_I' = 0
///
/// for every node I' behind the plane and its image I; M turns the component across the plane
/// round. (Nodes behind it that are only kept at rest take mass from the body: an error of the
/// first order in the cell size.)
///
/// A tile does this with its own part of the sums, before they are exchanged: whatever it gives
/// behind a plane, the images are in its own patch. Nodes on the plane lose their velocity across
/// it in prescribe_velocities.
/// @post nodes.mirrored
void mirror_sums(const SymmetryPlanes& planes, const Grid& grid, Nodes& nodes);

/// v_I' = M v_I behind the planes, and what the plane gives to the axial momentum of the
/// particles.
/// @pre nodes.motion holds the velocities of this step (solve_velocity)
/// @param[in,out] tally  impulses are added
void mirror_velocities(
    const SymmetryPlanes& planes,
    const Grid& grid,
    const GridShare& grid_share,
    const Nodes& nodes,
    GridTally& tally
);

}  // namespace barreno
