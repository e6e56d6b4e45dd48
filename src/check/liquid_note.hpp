// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// A warning that a load presses on a liquid with another pressure than that of its start, so that
/// it does not start at rest. Empty if there is none.
std::string liquid_note(const Scene& scene);

}  // namespace barreno
