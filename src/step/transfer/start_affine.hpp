// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"

#include <vector>

namespace barreno {

/// APIC: the first moments that belong to the bodies' velocities at t = 0. docs/method.md (2.12)
///
///   B_p = G_p D_p,   G = dv/dx of the deck's initial velocity, D as in project_affine
///
/// A body that begins with a spin has all of it then, on the grid too; with B = 0 the first step
/// would be one of PIC. Nothing to do for other transfers and for rigid bodies.
/// @pre  the first step's particles are placed, `affine` holds G (build_state)
/// @post `affine` holds B
void start_affine(const Grid& grid, std::vector<Particles>& sets);

}  // namespace barreno
