// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Pressures on faces and in cavities, absorbing faces and the body force, on the nodes.
/// docs/method.md (2.4)
///
/// @pre  project_sets of the same step
/// @post nodes.force holds them too; loads of torn faces have ended, which the ledger counts
void apply_loads(const Scene& scene, State& state);

/// Work of the same forces over the step, and their axial impulse, into the ledger; cavities grow
/// with their walls.
///
/// @pre  solve_motion of the same step, F and x still those at its start
/// @return the work [energy], this rank's part
ReproducibleSum tally_applied_loads(const Scene& scene, State& state);

}  // namespace barreno
