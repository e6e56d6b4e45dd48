// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Particles of a rigid body move with its velocity at the middle of the step, and nothing else of
/// them changes.
/// @param time  at the start of the step
/// @return the step that keeps them within half a cell; infinite where there are none [time]
double move_rigid_particles(
    const RigidMotions& motions, double time, const Grid& grid, Particles& particles
);

}  // namespace barreno
