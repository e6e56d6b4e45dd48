// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"
#include "grid/grid.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"

#include <vector>

namespace barreno {

/// APIC: first moments of the grid's velocity about every particle, which it keeps till the next
/// projection (project_affine). docs/method.md (2.12)
///
///   B_p = sum_I S_Ip v_I' (x_I - x_p)^T,   x_p = sum_I S_Ip x_I
///
/// Nothing to do for other transfers and for rigid bodies.
/// @pre nodes.motion is that of the step, positions and F are those before it
/// @return the kinetic energy of these moments, sum_p 1/2 m_p tr(B_p D_p^-1 B_p^T), of this rank
ReproducibleSum gather_affine(
    const Grid& grid, const std::vector<Nodes>& fields, std::vector<Particles>& sets
);

}  // namespace barreno
