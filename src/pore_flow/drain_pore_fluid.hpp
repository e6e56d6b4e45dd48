// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Lets pore fluid flow over the time since the last solve, when enough has passed; returns at once
/// in scenes without drained fluid. docs/method.md 7
///
/// @param dt  of the step that has just been made
/// @throws NumericalError if the solver does not converge; the fluid is then as before
void drain_pore_fluid(const Scene& scene, double dt, State& state);

}  // namespace barreno
