// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <array>

namespace barreno {

/// One number for every load of a scene.
using ByLoad = std::array<double, most_loads>;

/// Pressure of every load now: that of its table, or of the fluid in its cavity,
/// p = p0 - K ln(V / V0) [stress].
/// @throws NumericalError on every rank if a cavity has closed
ByLoad load_pressures(const Scene& scene, const State& state);

/// Forces of the pressures on surfaces of balls. docs/method.md (2.4)
///
///   f_I -= V_p (p e_p grad S_Ip + p F^-T grad e_p S_Ip),   p e_p T_Ip V_p in the radial direction
///   too
///
void project_surface_pressures(const Scene& scene, State& state);

/// Work of the same forces over the step on the mean nodal velocity, and their axial impulse, into
/// the ledger; cavities grow by the work that a unit pressure would have done on the velocity with
/// which particles move (with the mean one the fluid would gain energy at every step). Collective
/// if there is a pore fluid: the sum is exact, so that it is the same on any number of ranks.
/// @return the work [energy], this rank's part
WholeSum tally_surface_pressures(const Scene& scene, double dt, State& state);

/// The step that the fluids of cavities allow, if the particles allow dt: with
/// omega^2 = 8 n K / (rho a h) of a fluid against the first eighth of a cell of a wall (n = 3 of a
/// sphere, 2 of a disk), dt / sqrt(1 + (omega dt / 2)^2).
double stable_step_with_fluids(const Scene& scene, const State& state, double dt);

}  // namespace barreno
