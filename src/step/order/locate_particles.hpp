// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/continuum.hpp"

namespace barreno {

/// What locate_particles saw on this rank; agreed between the ranks with the step size.
struct Placement {
  bool someone_left = false;  ///< a particle is in a tile of another rank
  bool new_tile = false;      ///< a particle is in a tile that is not known to be active
  int interrupt = 0;          ///< signal that was received
};

/// Find every particle's cell (Particles::key). Particles outside the grid, not finite or given up
/// by their material are taken out and tallied by cause.
///
/// @post rows in tiles that are not active on this rank are unplaced; a set whose rows all keep
///       their cells is as it was, sorted or not
Placement locate_particles(const Continuum& continuum);

/// The same for the rows of a set from `first_row` on, none of which is lost.
void locate_newcomers(const Grid& grid, const Particles& particles, int first_row);

}  // namespace barreno
