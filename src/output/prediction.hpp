// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/step_shares.hpp"

#include <string>

namespace barreno {

/// What a run was expected to cost, before it began.
struct Prediction {
  /// Why times are not known, for a sentence; empty: they are. Steps that are 0 are not known
  /// either.
  std::string unknown;
  double steps = 0.0;
  double particle_steps = 0.0;  ///< slugs of the jet count from their launch on
  StepShares shares;            ///< how those of bodies distribute over cells and steps
  double nanoseconds = 0.0;     ///< of one core per particle-step
  double seconds = 0.0;         ///< of the steps, on all ranks
  double bytes = 0.0;           ///< of particles, grid and the program on all ranks
  double first_step = 0.0;      ///< [time]
};

}  // namespace barreno
