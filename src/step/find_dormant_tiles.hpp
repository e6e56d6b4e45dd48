// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Tiles whose particles have no velocity, and those whose sums still hold from the step before
/// (Nodes::kept): their particles have not changed since. docs/method.md 9
///
/// @pre the particles are in their tiles (place_particles)
void find_resting_tiles(const Scene& scene, State& state);

/// Of these, the tiles none of whose nodes moves by more than Dormancy::motion cells in a step:
/// their particles stay as they are, and the step that they allow is kept. Found before any
/// particle is asked to move.
///
/// @pre Dormancy::still is of this step (solve_velocity)
void find_dormant_tiles(const Scene& scene, State& state);

}  // namespace barreno
