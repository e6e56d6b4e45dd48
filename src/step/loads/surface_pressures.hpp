// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/loads/tractions.hpp"

namespace barreno {

/// Forces of the pressures on surfaces of balls. docs/method.md (2.4)
///
///   f_I -= V_p (p e_p grad S_Ip + p F^-T grad e_p S_Ip),   p e_p T_Ip V_p in the radial direction
///   too
///
/// @pre  set_load_pressures, release_torn_faces
void project_surface_pressures(const Tractions& tractions);

/// Work of the same forces over the step on the mean nodal velocity, and their axial impulse, into
/// the ledger.
/// @return the work [energy], this rank's part
ReproducibleSum tally_surface_pressures(const Tractions& tractions, OwnLedger& ledger);

/// Cavities grow by the work that a unit pressure would have done on the velocity with which
/// particles move (with the mean one the fluid would gain energy at every step). Collective if
/// there is a pore fluid: the sum is exact, so that it is the same on any number of ranks.
void grow_cavities(const Tractions& tractions, std::vector<Cavity>& cavities);

}  // namespace barreno
