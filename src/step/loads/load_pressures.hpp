// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/cavity.hpp"
#include "state/load_table.hpp"

#include <vector>

namespace barreno {

/// Pressure of a load: that of its table, or of the fluid in its cavity, p = p0 - K ln(V / V0)
/// [stress].
/// @throws NumericalError on every rank if the cavity has closed
double load_pressure(const PressureLoadSpec& load, const Cavity& cavity, double time);

/// The pressures of all loads at `time`, for the kernels that apply them.
/// @throws NumericalError on every rank if a cavity has closed
void set_load_pressures(
    const std::vector<PressureLoadSpec>& specs,
    const std::vector<Cavity>& cavities,
    double time,
    const LoadTable& loads
);

/// The step that the fluids of cavities allow, if the particles allow dt: with
/// omega^2 = 8 n K / (rho a h) of a fluid against the first eighth of a cell of a wall (n = 3 of a
/// sphere, 2 of a disk), dt / sqrt(1 + (omega dt / 2)^2).
double stable_step_with_fluids(const std::vector<Cavity>& cavities, double cell_size, double dt);

}  // namespace barreno
