// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// Why no tile of a scene may be dormant; empty: tiles may. docs/method.md 9
std::string why_all_awake(const Scene& scene);

/// What a node may move by in a step without waking a tile [cells]: the deck's word, or by default
/// nothing in scenes that start without stress (the answer is then the same to the last bit), and
/// the round-off of one cell in scenes that start in equilibrium, whose forces are round-off too.
double rest_motion(const Scene& scene);

}  // namespace barreno
