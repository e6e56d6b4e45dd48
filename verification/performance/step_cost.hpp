// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "least_work.hpp"
#include "scene/scene.hpp"

namespace barreno {

struct Cost {
  double nanoseconds = 0.0;  ///< per particle-step, median of five blocks of steps
  double best = 0.0;         ///< fastest block
  double bytes = 0.0;        ///< state and scratch arrays per particle
  LeastWork least;
};

/// Run a scene for twenty steps, then time five blocks of `steps`.
Cost time_steps(const Scene& scene, int steps);

}  // namespace barreno
