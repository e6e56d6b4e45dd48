// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/jet_monitor_section.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// Lines of the plan on the jet: cells per radius and per length of its slugs, its kind, depth by
/// the end of the run and its error. Empty without a jet.
/// @param monitor  of a jet that is formed in the run, which has a line if it meets a target
std::string jet_lines(const Scene& scene, const JetMonitorSpec& monitor = {});

}  // namespace barreno
