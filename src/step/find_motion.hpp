// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/mirror_walls.hpp"
#include "step/solve_contact.hpp"
#include "step/tally_step.hpp"

namespace barreno {

/// Grid velocity and what it does to the particles, with a smaller step if a strain increment is
/// too large. docs/method.md (2.5-2.6)
///
/// @pre  sums of the nodes are joined (join_nodes), and fields that meet have normals
/// @param[in,out] dt  may come back smaller
/// @post particles.grid_motion and particles.increment; tally.grid and tally.rigid
void find_motion(const Scene& scene, double& dt, State& state, StepTally& tally);

/// The strain alone, from the momenta that the nodes hold without any forces. docs/method.md (2.11)
///
/// @pre  as above, sums without forces (drop_forces)
/// @param clock, dt  of the step whose strain it is
/// @post particles.increment; particles.again_motion
void find_strain(const Scene& scene, const Clock& clock, double dt, State& state);

}  // namespace barreno
