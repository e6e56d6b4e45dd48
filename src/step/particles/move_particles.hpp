// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "grid/grid.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Commit the grid's motion to the positions. docs/method.md (2.7)
///
///   x_p <- x_p + dt v
///
/// In axisymmetry the radius follows the hoop stretch, r_p <- r_p exp(dt L_hoop): r_p / F_hoop
/// stays the radius at the start exactly, and no particle crosses the axis. (The r-weighted average
/// velocity belongs to the centre of mass of the ring, not to r_p, and would drift from F near the
/// axis.)
/// @param grid  with the step of each tile (TileFrame::dt)
void move_particles(const Grid& grid, Rows rows, Particles& particles);

}  // namespace barreno
