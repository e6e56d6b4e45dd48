// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <vector>

namespace barreno {

/// Length of the last step that each tile of the box took, by the tile's number (BoxTiles) [time];
/// 0: the tile held no particle. The same on every rank and in a resumed run, and from a checkpoint
/// until the first step after a resume. Collective.
std::vector<double> last_tile_steps(const State& state);

}  // namespace barreno
