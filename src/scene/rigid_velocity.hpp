// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Velocity of a rigid body over the step from `time` on: that of its middle [length/time].
inline Vector rigid_velocity(const BodySpec& body, double time, double dt) {
  Vector v = body.motion.velocity;
  const double factor = body.motion.factor(time + 0.5 * dt);
  for (double& component : v) component *= factor;
  return v;
}

}  // namespace barreno
