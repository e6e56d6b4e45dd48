// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What a run of this scene will do: bodies, what is modelled and what is not and why, particles,
/// memory, step size and number of steps. Nothing is written and no particle is kept.
std::string plan_text(const Scene& scene, const std::vector<std::string>& notes);

}  // namespace barreno
