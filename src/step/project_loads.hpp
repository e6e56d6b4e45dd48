// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Forces of the pressure loads on the faces of their particles. docs/method.md (2.4)
///
///   f_I += S_face,I f,   f = -p J F^-T N A   (Nanson's formula on the particle's own deformed
///   face)
///
void project_loads(const Scene& scene, State& state);

/// Work of the same forces over the step on the mean nodal velocity, and their axial impulse, into
/// the ledger.
/// @return the work [energy], this rank's part
WholeSum tally_loads(const Scene& scene, double dt, State& state);

}  // namespace barreno
