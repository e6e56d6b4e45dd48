// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/node_conditions.hpp"
#include "support/scenes.hpp"

namespace barreno::testing {

/// A symmetry plane at x = 0, and a wall at y = 16 whose velocity grows with time.
inline Scene moving_wall(Mode mode) {
  Scene scene = box_scene(mode, 1.0, {0.0, 0.0, 0.0}, {8.0, 16.0, 0.0}, elastic(1e9, 0.3, 1e3));
  add_symmetry(scene, Face::x_lower);
  ConditionSpec wall{"wall", Face::y_upper, ConditionKind::prescribed_velocity, {3.0, -8.0, 0.0}};
  wall.factor = {{0.0, 1.0}, {0.0, 2.0}};
  scene.conditions.push_back(wall);
  return scene;
}

inline NodeConditions conditions_of(const Scene& scene) {
  return make_node_conditions(scene.conditions, start_alone(scene).grid);
}

}  // namespace barreno::testing
