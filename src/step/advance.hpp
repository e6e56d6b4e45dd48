// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/step_result.hpp"

namespace barreno {

/// One explicit step in the scene's order (Order), at most to `next_time`. docs/method.md numbers
/// the equations.
StepResult advance(const Scene& scene, double next_time, State& state);

}  // namespace barreno
