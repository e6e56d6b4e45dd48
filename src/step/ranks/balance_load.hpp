// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/partition.hpp"
#include "step/continuum.hpp"

#include <vector>

namespace barreno {

/// Every so many steps, compare what the ranks' nodes and particles have cost and, once ranks have
/// waited twice as long as a change takes, share the parcels anew by measured cost if that gains a
/// noticeable part of a step.
/// Collective. Answers do not depend on who owns what (docs/method.md 3).
///
/// @param continuum  its effort: since the ranks last compared; starts anew
/// @param[in,out] sharing  what ranks have waited for each other, and what a change takes
void balance_load(const Clock& clock, const Continuum& continuum, LoadBalance& sharing);

/// Seconds that each tile of the box has cost, over all ranks. Collective.
std::vector<ParcelCost> parcel_costs(
    const Grid& grid, const std::vector<Particles>& sets, const Effort& effort
);

}  // namespace barreno
