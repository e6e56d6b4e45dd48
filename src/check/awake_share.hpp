// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <functional>

namespace barreno {

/// The part of a body's particle-steps that dormant tiles do not skip (docs/method.md 9), where all
/// that moves at the start is a jet; 1 elsewhere. A tile wakes when what the grid spreads ahead
/// of the waves arrives from where the jet first meets a body.
/// @param dt  of the run's steps [time]
double awake_share(const Scene& scene, const BodySpec& body, double dt);

/// Whether awake_share() knows when dormant tiles wake.
bool foresees_dormancy(const Scene& scene);

/// One of the few places that stand for all of a body.
struct AwakePart {
  Vector x;
  int level;         ///< of the cells there
  double particles;  ///< of the run, relative to those of other places
  double awake;      ///< part of the time
};
void for_each_awake_part(
    const Scene& scene,
    const BodySpec& body,
    double dt,
    const std::function<void(const AwakePart&)>& visit
);

}  // namespace barreno
