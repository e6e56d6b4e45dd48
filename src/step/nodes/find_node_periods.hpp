// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/node_conditions.hpp"
#include "state/particles.hpp"
#include "state/subcycling.hpp"
#include "step/boundary/symmetry_planes.hpp"

#include <vector>

namespace barreno {

/// How many parts of a step every node takes at once. docs/method.md 12
///
/// A node is *steady* if all tiles that give it mass have one period P. Its mass and force stay
/// over P parts, in which its velocity changes by the same dt f / m each, and (12.2) is one step:
///
///   T = P dt,   v' = v + T f / m,   du = T v'
///
/// So it is solved once, with the part that ends the step of its tiles. Others are solved in each
/// part, and so are those that a condition moves in time. A node that follows the coarser lattice
/// takes the step of the coarser tile, and one behind a symmetry plane that of its image.
///
/// Tiles count that hold particles or that particles may enter before the step is over: which
/// others are active depends on earlier steps, and the answer must not.
///
/// @pre  plan_subcycles has found the periods of the step
/// @post Subcycling::node_period and node_periods; tiles that do not count have the longest period
void find_node_periods(
    const SymmetryPlanes& planes,
    const NodeConditions& conditions,
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Subcycling& subcycling
);

}  // namespace barreno
