// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

namespace barreno {

/// Cells, matrix and solver of the pore flow: scratch, hidden from what does not solve.
struct PoreNetwork;

/// What the pore flow keeps between its solves, the same on every rank.
struct PoreFlowState {
  bool on = false;        ///< the scene has it
  double waiting = 0.0;   ///< time that has not drained yet [time]
  double interval = 0.0;  ///< between two solves [time]
  double inflow = 0.0;    ///< fluid through the surfaces of rock since t = 0 [volume]
  double removed = 0.0;   ///< with particles that were taken out or became debris [volume]
  double fluid = 0.0;     ///< in the pores after the last solve, at its initial density [volume]
  double initial_fluid = 0.0;  ///< before the first solve [volume]
  long solves = 0;
  double iterations = 0.0;  ///< of all solves
  std::shared_ptr<PoreNetwork> network;
};

}  // namespace barreno
