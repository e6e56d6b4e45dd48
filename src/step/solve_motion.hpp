// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/boundary/mirror_nodes.hpp"
#include "step/contact/solve_contact.hpp"
#include "step/tally_step.hpp"

namespace barreno {

/// Grid velocity and what it does to the particles, with a smaller step if a strain increment is
/// too large. docs/method.md (2.5-2.6)
///
/// @pre  sums of the nodes are joined (sum_halos), and fields that meet have normals
/// @param[in,out] dt  may come back smaller
/// @post particles.grid_motion and particles.increment; tally.grid and tally.rigid
void solve_motion(const Scene& scene, double& dt, State& state, StepTally& tally);

/// The same for tiles that the part of a step has left within their own steps, which end with it
/// (Subcycling), and for nodes that wait for the ends of these steps.
///
/// @param[in,out] tally  what these nodes do is added to tally.grid
void move_other_tiles(const Scene& scene, State& state, StepTally& tally);

/// The strain alone, from the momenta that the nodes hold without any forces. docs/method.md (2.11)
///
/// @pre  as above, sums without forces (drop_forces)
/// @param clock  of the step whose strain it is; the tiles have its length (set_tile_steps)
/// @post particles.increment; particles.second_pass_motion
void solve_strain(const Scene& scene, const Clock& clock, State& state);

}  // namespace barreno
