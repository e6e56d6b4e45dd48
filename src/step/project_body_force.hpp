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
void project_body_force(const Scene& scene, State& state);

/// Work of the same forces over the step on the mean velocity, and their axial impulse, into the
/// ledger.
/// @pre  particles.grid_motion holds the motion of this step (interpolate_motion)
/// @return the work [energy], this rank's part
WholeSum tally_body_force(const Scene& scene, double dt, State& state);

}  // namespace barreno
