// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Steps between two physical sorts of the rows: long enough to cost nothing, short enough to keep
/// locality.
inline constexpr long steps_per_permutation = 50;

/// What locate_particles saw on this rank; agreed between the ranks with the step size.
struct Placement {
  bool someone_left = false;  ///< a particle is in a tile of another rank
  bool new_tile = false;      ///< a particle is in a tile that is not known to be active
  int interrupt = 0;          ///< signal that was received
};

/// Why row p is to be taken out, a RemovalCause; -1: it stays.
int removal_cause(const Grid& grid, const Particles& particles, int p);

/// The fault of a particle that is to be taken out for this cause; none for causes that its place
/// and velocity tell.
Fault fault_of_cause(int cause);

/// Find every particle's cell. Particles outside the grid, not finite or given up by their material
/// are taken out and tallied by cause.
Placement locate_particles(const Scene& scene, State& state);

/// Bring every particle to the rank that owns its tile, activate the tiles that hold particles, and
/// sort the rows by (tile, cell, id). Collective if anything moved between ranks or a tile is new.
///
/// @param placement  agreed between the ranks
void place_particles(const Scene& scene, const Placement& placement, State& state);

/// Give the tiles of the box to other ranks, `owner` by tile; every particle goes home. Collective.
void give_tiles(const Scene& scene, const std::vector<int>& owner, State& state);

}  // namespace barreno
