// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Set all nodal sums of the active tiles to zero, but for those that are kept.
void clear_nodes(const Grid& grid, Nodes& nodes);

/// Project mass, momentum and internal force of every particle to the nodes of its support, in one
/// pass over the particles because the weights cost as much as the sums. docs/method.md (2.1-2.3)
///
///   m_I += S_Ip m_p,   p_I += S_Ip m_p v_p,   f_I -= V_p (sigma_p - q_p I) . grad S_Ip
///
/// and in axisymmetry f_I,r -= V_p (sigma_zz - q_p) T_Ip (z the hoop direction).
///
/// Tiles that keep their sums (Nodes::sums_kept) have them already.
///
/// @param[in]     particles  sorted by place_particles since they last moved
/// @param[in,out] nodes      sums of each tile's own particles in its own patch: partial
/// @post sum_I m_I = sum_p m_p on this rank, to round-off
void project_particles(const Grid& grid, const Particles& particles, Nodes& nodes);

}  // namespace barreno
