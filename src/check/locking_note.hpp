// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// A warning that a material hardly changes its volume and how its particles would lock: with shape
/// functions that are linear between nodes and more than one particle per cell and direction, every
/// particle holds its own volume, more demands than nodes have velocities (a block of K = 5000 G
/// settles 44 % too little; verification/extreme_rows/stretch.py). Empty if there is none.
std::string locking_note(const Scene& scene, int material);

}  // namespace barreno
