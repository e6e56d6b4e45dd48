// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/dormant/dormant_nodes.hpp"

namespace barreno {

/// Which tiles' nodes solve_velocity leaves as the last step solved them (Dormancy::unsolved):
/// those that stay motionless and of which no finer tile is solved, which takes nodes from their
/// motion. Nothing else sees it, so that the answer is the same bits whatever is left.
void find_unsolved_tiles(const Grid& grid, const DormantNodes& nodes);

}  // namespace barreno
