// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/dormancy.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"
#include "state/subcycling.hpp"

namespace barreno {

/// Velocity, velocity increment and velocity gradient of the grid at every particle. docs/method.md
/// (2.6)
///
///   v = S_Ip v_I',   dv = S_Ip (v_I' - v_I),   dt L = dt v_I' (x) grad S_Ip,   dt L_hoop = dt T_Ip
///   v_I,r'
///
/// Particles of dormant tiles get none of it (Dormancy), nor do those of tiles within their own
/// steps; over a step of several parts v is the mean, dv the sum (Subcycling).
///
/// The step dt is that of the particle's tile (TileFrame).
///
/// Nothing is committed: a step that turns out too large is taken again from solve_velocity.
///
/// @post particles.grid_motion and particles.increment (dt L: xx xy yx yy hoop)
/// @return largest |D| dt of the set on this rank, as it counts towards Largest Strain (VoidRule)
/// [-]
double interpolate_motion(
    const Grid& grid,
    const Dormancy& dormancy,
    const Subcycling& subcycling,
    const Nodes& nodes,
    Particles& particles
);

}  // namespace barreno
