// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"
#include "state/subcycling.hpp"

#include <vector>

namespace barreno {

/// Whether a particle that has moved with a part of a step has come into a tile whose own step goes
/// on, that is not active or has smaller cells than the one it comes from: then all tiles must end
/// their steps, for such a tile cannot take it in. plan_subcycles foresees most of that.
///
/// @pre the particles' keys are those that the part began with
bool find_early_arrivals(
    const Grid& grid, const std::vector<Particles>& sets, const Subcycling& subcycling
);

}  // namespace barreno
