// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// Warnings of sizes, speeds and times that look like a forgotten unit, a sentence each: a jet far
/// slower, faster, thinner or wider than jets are, a target of tens of metres or less than a
/// millimetre in its path, a body thinner than a cell, an end that takes ten million steps.
std::vector<std::string> scale_notes(const Scene& scene);

}  // namespace barreno
