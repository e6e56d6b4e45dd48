// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/output.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace barreno {

/// Advance the state to the scene's end, writing what is due on the way.
RunVerdict run(const Scene& scene, State& state, Output& output);

}  // namespace barreno
