// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// Lines of the plan on the jet: cells per radius and per length of its slugs, its kind, depth by
/// the end of the run and its error. Empty without a jet.
std::string jet_lines(const Scene& scene);

}  // namespace barreno
