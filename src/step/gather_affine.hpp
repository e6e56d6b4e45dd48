// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// APIC: first moments of the grid's velocity about every particle, which it keeps till the next
/// projection (project_affine). docs/method.md (2.12)
///
///   B_p = sum_I S_Ip v_I' (x_I - x_p)^T,   x_p = sum_I S_Ip x_I
///
/// Their kinetic energy, sum_p 1/2 m_p tr(B_p D_p^-1 B_p^T), goes to the ledger as `remembered`.
/// Nothing to do for other transfers.
/// @pre nodes.motion is that of the step, positions and F are those before it
void gather_affine(const Scene& scene, State& state);

}  // namespace barreno
