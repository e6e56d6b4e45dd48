// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace barreno {

/// What the first steps of a scene cost on this core.
struct Probe {
  double seconds = 0.0;        ///< of one step
  double particles = 0.0;      ///< in it, rigid bodies aside
  double program_bytes = 0.0;  ///< that this process used before
  double dt = 0.0;             ///< longest of its steps, at the scene's own cell size [time]
  std::vector<std::pair<std::string, double>> shares;  ///< of a step: verb and part of the time
};

/// Take the first steps of the scene on this rank alone and drop them: some milliseconds. A large
/// scene is probed with larger cells. Implicit steps of the pore flow are left out.
Probe probe_cost(const Scene& scene);

/// The part of the probe's time in verbs whose names begin so.
double share_of(const Probe& probe, const std::string& verb);

}  // namespace barreno
