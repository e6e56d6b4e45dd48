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

/// Advance the state to the scene's end, writing what is due on the way. A signal, and a file that
/// cannot be written, end it with a checkpoint of the step.
RunVerdict run(const Scene& scene, State& state, Output& output, Checkpoints& checkpoints);

/// run() and the last words. @return the process's exit code
/// @throws FileError on every rank if those cannot be written
int run_to_end(const Scene& scene, State& state, Output& output, const RunDescription& description);

}  // namespace barreno
