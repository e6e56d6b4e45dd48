// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Force per mass of the scene on every particle. docs/method.md (2.4)
///
///   f_I += S_Ip m_p b(X_p, t)
///
/// A manufactured force starts with half a step: the velocities of the scheme belong to the middles
/// of steps, and the exact motion is compared with at the ends.
/// @param clock  at the start of the step
void project_body_force(
    const BodyForceSpec& force,
    const Clock& clock,
    const Grid& grid,
    const std::vector<Particles>& sets,
    const std::vector<Nodes>& nodes
);

/// Work of the same forces over the step on the mean velocity, and their axial impulse, into the
/// ledger.
/// @pre  particles.grid_motion holds the motion of this step (interpolate_motion)
/// @return the work [energy], this rank's part
ReproducibleSum tally_body_force(
    const BodyForceSpec& force,
    const Clock& clock,
    const Grid& grid,
    const std::vector<Particles>& sets,
    OwnLedger& ledger
);

}  // namespace barreno
