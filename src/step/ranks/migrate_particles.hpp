// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"

#include <vector>

namespace barreno {

/// Send every particle that is in a tile of another rank there. Collective.
///
/// @pre  particles in tiles that are not active here are unplaced (locate_particles)
/// @post newcomers are unplaced too; sets that no particle leaves or joins are unchanged, sorted or
///       not
/// @return of each set, its first row that has come: newcomers are the last rows
std::vector<int> migrate_particles(const Grid& grid, std::vector<Particles>& sets);

}  // namespace barreno
