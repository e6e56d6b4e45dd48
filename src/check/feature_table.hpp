// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "check/probe_cost.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// What a run may do beyond moving particles through a grid: on or off and why, the bytes that it
/// costs each particle, and its part of the time in the first steps.
std::string feature_table(const Scene& scene, const Probe& probe);

}  // namespace barreno
