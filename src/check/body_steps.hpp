// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/step_shares.hpp"

#include <vector>

namespace barreno {

/// Particle-steps of all bodies that are computed, as expected before a run; those of the jet are
/// left out.
struct BodySteps {
  double all = 0.0;    ///< with one step for all, dormant tiles included
  double awake = 0.0;  ///< with one step for all
  double taken = 0.0;  ///< where slow tiles take several parts at once (Step/Subcycles)
  StepShares shares;   ///< how `taken` distributes over cells and steps
};

/// Tiles that the jet passes through step with it, others as their material bears at rest.
/// @param counts  particles of every body, then of slugs (particle_counts)
/// @param dt      of the run's steps, or of their parts [time]
BodySteps steps_of_bodies(const Scene& scene, const std::vector<long long>& counts, double dt);

}  // namespace barreno
