// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace barreno {

/// The part of a body's particle-steps that dormant tiles do not skip (docs/method.md 9), where all
/// that moves at the start is a jet; 1 elsewhere. A tile wakes when the front that runs ahead of
/// the waves from where the jet first meets a body arrives.
/// @param dt  of the run's steps [time]
double awake_share(const Scene& scene, const BodySpec& body, double dt);

/// Particle-steps of all bodies that are not skipped, by the level of their cells, of a sum of 1;
/// those of the jet are left out. One step for all. Empty where all cells have one size.
std::vector<double> steps_by_level(const Scene& scene, double dt);

}  // namespace barreno
