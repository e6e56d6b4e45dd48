// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "scene/scene.hpp"
#include "state/dormancy.hpp"
#include "state/particles.hpp"
#include "state/subcycling.hpp"

#include <vector>

namespace barreno {

/// Into how many parts a step is divided, and how many of them every tile takes at once: as many as
/// the stable step of its particles allows, and no more than a tile whose particles may come into
/// it before the step is over. The same on any ranks. docs/method.md 12
///
/// @pre  the particles are in their tiles (place_particles)
/// @param dt         length of a part: the least stable step of all particles [time]
/// @param time_left  a step ends no later than in this time [time]
/// @return whether particles of any rank may come into tiles that are not active (reached_tiles):
///         then these must be, and the step be planned again
bool plan_subcycles(
    const StepSpec& step,
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    double dt,
    double time_left,
    Subcycling& subcycling
);

}  // namespace barreno
