// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/checkpoints.hpp"
#include "output/output.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"
#include "step/advance.hpp"

namespace barreno {

/// Which particle stopped the run, why, and what to do. Collective.
std::string failure_sentence(const Scene& scene, const State& state, const StepResult& result);

/// Advance the state to the scene's end, writing what is due on the way.
RunVerdict run(const Scene& scene, State& state, Output& output, Checkpoints& checkpoints);

}  // namespace barreno
