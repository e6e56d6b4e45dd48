// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/mirror_walls.hpp"

namespace barreno {

/// Mass, momentum and resultants of the stress of all particles on the nodes of their fields.
/// docs/method.md (2.1-2.3)
void project_sets(const Scene& scene, State& state);

/// Of these, keep mass and momentum: where velocities are asked for and no forces.
void drop_forces(State& state);

/// The last that happens to the sums of every tile before they are added: symmetry planes, then
/// what other ranks hold. Collective.
void join_nodes(const Scene& scene, State& state);

}  // namespace barreno
