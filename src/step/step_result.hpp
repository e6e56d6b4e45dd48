// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/particles.hpp"

#include <string>

namespace barreno {

/// How a step went; the same on every rank.
struct StepResult {
  bool stopped = false;     ///< a material failed whose policy is to stop
  ParticleId failed = -1;   ///< the first particle that failed, in the order of ids
  int material = -1;        ///< its material
  int interrupt = 0;        ///< signal that some rank received
  std::string not_drained;  ///< why the pore fluid could not flow; empty: it could
};

}  // namespace barreno
