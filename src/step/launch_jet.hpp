// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Make the particles of every slug whose launch time has come, each on the rank that owns its
/// place, and tally what was launched. A slug's centre is where it has flown since it crossed the
/// launch plane.
///
/// @post state.stable_step allows for the new particles
void launch_jet(const Scene& scene, State& state);

}  // namespace barreno
