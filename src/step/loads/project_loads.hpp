// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/loads/tractions.hpp"

namespace barreno {

/// Forces of the pressure loads on the faces of their particles, and the impedance of those that
/// absorb waves. docs/method.md (2.4)
///
///   f_I += S_face,I f,   f = -p J F^-T N A   (Nanson's formula on the particle's own deformed
///   face)
///
/// @pre  set_load_pressures, release_torn_faces
/// @post particles.shear_modulus of particles with non-reflecting faces
void project_loads(const Tractions& tractions, const std::vector<MaterialSpec>& materials);

/// Work of the same forces over the step on the mean nodal velocity, and their axial impulse, into
/// the ledger.
/// @pre  project_loads of the same step
/// @return the work [energy], this rank's part
ReproducibleSum tally_loads(
    const Tractions& tractions, const Dormancy& dormancy, OwnLedger& ledger
);

}  // namespace barreno
