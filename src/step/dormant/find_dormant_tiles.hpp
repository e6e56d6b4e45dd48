// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/clock.hpp"
#include "state/dormancy.hpp"
#include "state/effort.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"
#include "state/subcycling.hpp"

#include <vector>

namespace barreno {

/// Tiles that may be dormant, whose particles have no velocity, and those of them that keep the
/// sums of the step before (Nodes::sums_kept): their particles have not changed since.
/// docs/method.md 9
///
/// @param horizon  what the detonation reaches until then is awake: the end of the longest step
/// that
///                 a tile may begin now [time]
/// @pre the particles are in their tiles (place_particles)
void find_dormant_candidates(
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Subcycling& subcycling,
    Dormancy& dormancy,
    std::vector<Nodes>& fields,
    Effort& effort,
    double horizon
);

/// The dormant tiles: candidates none of whose nodes moves by more than Dormancy::motion cells in a
/// step. Their particles stay as they are, as do those of tiles within their own steps. Found
/// before any particle is asked to move.
///
/// @pre Dormancy::motionless is of this step (solve_velocity)
/// @post Particles::dormant, chunk_part and settled_chunks of all sets
void find_dormant_tiles(
    const StepSpec& step,
    const Clock& clock,
    const Grid& grid,
    std::vector<Particles>& sets,
    const Subcycling& subcycling,
    Dormancy& dormancy
);

}  // namespace barreno
