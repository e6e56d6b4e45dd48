// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/partition.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// Every so many steps, compare what the ranks' particles have cost and, where one rank works
/// noticeably longer than the mean, share the tiles anew by measured cost. Collective. Answers do
/// not depend on who owns what (docs/method.md 3).
void balance_load(const Scene& scene, State& state);

/// Seconds that the particles in each tile of the box have cost, over all ranks. Collective.
std::vector<TileCost> tile_costs(const State& state);

}  // namespace barreno
