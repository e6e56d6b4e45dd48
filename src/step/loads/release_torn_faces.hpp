// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Ends the loads on the faces of particles that have been stretched to more than twice their size
/// in a direction or are held as debris, and counts those particles. docs/method.md (2.4)
///
/// A fluid presses on a torn-off piece from all sides. With its one loaded face it would be
/// accelerated for ever: a ring of steel of 0.25 mm by 70 MPa to 3.5 km/s within 100 us.
///
/// @pre the particles are in their tiles (place_particles)
/// @post loads.loaded_tiles: those of the faces that remain
/// @return particles of this rank that lost their loads
double release_torn_faces(
    const Grid& grid,
    const std::vector<Nodes>& nodes,
    const std::vector<Particles>& sets,
    LoadTable& loads
);

}  // namespace barreno
