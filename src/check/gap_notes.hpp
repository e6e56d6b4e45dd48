// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// Warnings of gaps that look like a mistake: one between bodies in the jet's path, or one of less
/// than a cell between boxes that do not move to each other, which act on each other across it
/// through their shared nodes. A sentence for the first of each kind.
std::vector<std::string> gap_notes(const Scene& scene);

}  // namespace barreno
