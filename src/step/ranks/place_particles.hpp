// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/order/locate_particles.hpp"

#include <vector>

namespace barreno {

/// Steps between two physical sorts of the rows: long enough to cost nothing, short enough to keep
/// locality.
inline constexpr long steps_per_permutation = 50;

/// Every particle is looked for again, as where tiles get other numbers.
void forget_keys(std::vector<Particles>& sets);

/// Bring every particle to the rank that owns its tile, activate the tiles that hold particles, and
/// sort the rows by (tile, cell, id). Collective if anything moved between ranks or a tile is new.
///
/// @param placement  agreed between the ranks
/// @param step       number of the step
void place_particles(const Placement& placement, long step, const Continuum& continuum);

/// Activate tiles that particles are about to enter too, whichever rank they belong to. Collective.
///
/// @param reached  what reached_tiles found on this rank
void activate_reached_tiles(const std::vector<int>& reached, long step, const Continuum& continuum);

/// Give the parcels of the box to other ranks, `owner` by parcel; every particle goes home.
/// Collective.
void give_parcels(const std::vector<int>& owner, long step, const Continuum& continuum);

}  // namespace barreno
