// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Ends the loads on the faces of particles that have been stretched to more than twice their size
/// in a direction or are held as debris; the particles are
/// counted in the ledger. docs/method.md (2.4)
///
/// A fluid presses on a torn-off piece from all sides. With its one loaded face it would be
/// accelerated for ever: a ring of steel of 0.25 mm by 70 MPa to 3.5 km/s within 100 us.
void release_torn_faces(const Scene& scene, State& state);

/// Forces of the pressure loads on the faces of their particles. docs/method.md (2.4)
///
///   f_I += S_face,I f,   f = -p J F^-T N A   (Nanson's formula on the particle's own deformed
///   face)
///
void project_loads(const Scene& scene, State& state);

/// Work of the same forces over the step on the mean nodal velocity, and their axial impulse, into
/// the ledger.
/// @return the work [energy], this rank's part
double tally_loads(const Scene& scene, double dt, State& state);

}  // namespace barreno
