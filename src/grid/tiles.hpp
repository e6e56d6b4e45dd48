// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "grid/partition.hpp"

#include <vector>

namespace barreno {

/// The background grid of a scene with no tile active yet; every parcel's owner is rank 0 until
/// they are dealt out.
///
/// @param reach  nodes beyond its own tile that a particle can give to (a shape function's reach())
Grid make_grid(const Scene& scene, int reach, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// Say which rank owns every parcel of the box.
void set_owners(const std::vector<int>& owner, Grid& grid);

/// Deal the parcels out by the particles in them: ParcelCost::particles counts them, in all ranks.
///
/// @throws DeckError where a rank gets more than can be counted in 32 bits
void share_parcels(const std::vector<ParcelCost>& particles, Grid& grid);

/// Make exactly the listed tiles active on this rank, find neighbours and ghosts, and say which
/// copy of each node counts. Collective.
///
/// @param owned  box ids of tiles that this rank owns, ascending
void activate_tiles(Grid& grid, const std::vector<int>& owned);

/// The step that the tiles take next (TileFrame::dt), those of other ranks included [time].
void set_tile_steps(const Grid& grid, double dt);

/// What of its step every tile takes at once (TileFrame::part).
void set_part_of_steps(const Grid& grid, double dt);

}  // namespace barreno
