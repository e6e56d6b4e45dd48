// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Send every particle that is in a tile of another rank there. Collective.
///
/// @pre  particles in tiles that are not active here have no key (locate_particles)
/// @post newcomers have none either; sets that nobody leaves or joins are as they were, sorted or
/// not
void migrate_particles(State& state);

}  // namespace barreno
