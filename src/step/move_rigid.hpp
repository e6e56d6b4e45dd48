// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Particles of a rigid body move with its velocity at the middle of the step, and nothing else of
/// them changes. @return the step that keeps them within half a cell [time]
double move_rigid(const Scene& scene, const Clock& clock, double dt, Particles& particles);

}  // namespace barreno
