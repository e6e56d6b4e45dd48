// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/dormancy.hpp"
#include "state/nodes.hpp"
#include "state/subcycling.hpp"

namespace barreno {

/// Begins a part of a step: tiles whose own step begins with it get its length.
/// @param dt  of the part [time]
void start_tile_steps(const Grid& grid, double dt, const Subcycling& subcycling);

/// Which tiles end their steps with a part that the nodes have taken, and what moved their nodes
/// over all of such a step: the mean of the velocities, by length of the parts, and the sum of
/// their changes. Momentum is kept, for each particle gets what its mass at the nodes got.
///
/// @pre  TileFrame::part is the length of the part
/// @post Subcycling::ends, whole where nodes took several parts of a step; TileFrame::dt of tiles
/// that end
void end_tile_steps(const Grid& grid, const Nodes& nodes, const Subcycling& subcycling);

/// The same for all tiles that did not end their steps with the part, so that a step may be cut
/// short.
void end_other_tile_steps(const Grid& grid, const Nodes& nodes, const Subcycling& subcycling);

/// Tiles whose steps go on: what moved those of their nodes that were solved in the part, and the
/// momenta of their particles at these nodes, which gain m_I dv_I. (12.1)
void carry_tile_steps(
    const Grid& grid, const Nodes& nodes, const Dormancy& dormancy, const Subcycling& subcycling
);

}  // namespace barreno
