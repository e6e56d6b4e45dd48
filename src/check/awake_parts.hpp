// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <functional>

namespace barreno {

/// Whether it is known when dormant tiles wake (docs/method.md 9): all that moves at the start is a
/// jet. A tile wakes when what the grid spreads ahead of the waves arrives from where the jet first
/// meets a body.
bool foresees_dormancy(const Scene& scene);

/// One of the few places that stand for all of a body.
struct AwakePart {
  Vector x;
  int level;         ///< of the cells there
  double particles;  ///< of the run, relative to those of other places
  double awake;      ///< part of the time; 1 where nothing is foreseen
};
/// @param dt  of the run's steps [time]
void for_each_awake_part(
    const Scene& scene,
    const BodySpec& body,
    double dt,
    const std::function<void(const AwakePart&)>& visit
);

}  // namespace barreno
