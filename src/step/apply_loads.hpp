// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// What acts on the bodies from outside, as the deck has it.
struct ExternalForces {
  const std::vector<PressureLoadSpec>& loads;
  const BodyForceSpec& body_force;
  const std::vector<MaterialSpec>& materials;  ///< of the bodies, for faces that absorb waves
};
inline ExternalForces forces_of(const Scene& scene) {
  return {scene.loads, scene.body_force, scene.materials};
}

/// Pressures on faces and in cavities, absorbing faces and the body force, on the nodes.
/// docs/method.md (2.4)
///
/// @pre  project_sets of the same step
/// @post nodes.force holds them too; loads of torn faces have ended, which the ledger counts
void apply_loads(const ExternalForces& forces, State& state);

/// Work of the same forces over the step, and their axial impulse, into the ledger; cavities grow
/// with their walls.
///
/// @pre  solve_motion of the same step, F and x still those at its start
/// @return the work [energy], this rank's part
ReproducibleSum tally_applied_loads(const BodyForceSpec& body_force, State& state);

}  // namespace barreno
