// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/ledger.hpp"
#include "state/particles.hpp"
#include "state/subcycling.hpp"
#include "step/order/locate_particles.hpp"

#include <vector>

namespace barreno {

/// Where a part of a step has brought the particles that took it.
struct Arrivals {
  bool strays = false;  ///< some are too far from their tile to stay in it (StrayRule), or lost
  bool early = false;  ///< such a one is where it cannot be taken in: in a tile whose own step goes
                       ///< on, that has smaller cells than the one it comes from, or where
                       ///< plan_subcycles has not foreseen it
};

/// If a particle is early, all tiles must end their steps. plan_subcycles foresees most of that.
///
/// @pre the particles are in the tiles that the part began with
Arrivals find_early_arrivals(
    const Grid& grid, const std::vector<Particles>& sets, const Subcycling& subcycling
);

/// New keys for the strays; what is lost is taken out. All others keep theirs, though they may have
/// come into another cell.
///
/// @pre none is early
/// @post strays in tiles of other ranks are unplaced
Placement place_strays(
    const Grid& grid, const Subcycling& subcycling, std::vector<Particles>& sets, OwnLedger& ledger
);

}  // namespace barreno
