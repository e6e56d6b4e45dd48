// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/partition.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// Every so many steps, compare what the ranks' nodes and particles have cost and, once ranks have
/// waited twice as long as a change takes, share the tiles anew by measured cost if that gains a
/// noticeable part of a step.
/// Collective. Answers do not depend on who owns what (docs/method.md 3).
void balance_load(const Scene& scene, State& state);

/// Seconds that each tile of the box has cost, over all ranks. Collective.
std::vector<TileCost> tile_costs(const State& state);

}  // namespace barreno
