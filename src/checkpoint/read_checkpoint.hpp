// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/find_checkpoint.hpp"
#include "state/state.hpp"

namespace barreno {

/// Sets a state that build_state made from the same deck to that of the checkpoint. On as many
/// ranks as wrote it every rank gets its own rows and sums back, and the run goes on bit for bit;
/// on another number tiles are shared anew and rank 0 takes the sums of all. Collective.
/// @throws FileError on every rank
void read_checkpoint(const Checkpoint& checkpoint, State& state);

}  // namespace barreno
