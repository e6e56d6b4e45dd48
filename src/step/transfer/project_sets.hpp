// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/effort.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"

#include <vector>

namespace barreno {

/// Mass, momentum and resultants of the stress of all particles on the nodes of their fields.
/// docs/method.md (2.1-2.3)
void project_sets(
    const Grid& grid, const std::vector<Particles>& sets, std::vector<Nodes>& fields, Effort& effort
);

/// Of these, keep mass and momentum: where velocities are asked for and no forces.
void drop_forces(const Grid& grid, std::vector<Nodes>& fields);

}  // namespace barreno
