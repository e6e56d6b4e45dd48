// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/scenes.hpp"

#include <initializer_list>

namespace barreno::testing {

/// Plane strain, 16 x 16 cells of size 1, which are 2 x 2 tiles of 8 x 8 cells; a block of four
/// particles in the first tile, with ids 1 to 4.
inline Scene four_particles() {
  Scene scene =
      box_scene(Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 16.0}, elastic(1e6, 0.3, 1000.0));
  add_box(scene, "block", {0.0, 0.0}, {2.0, 2.0}, 1);
  return scene;
}

inline void put(Particles& particles, int row, double x, double y) {
  particles.position(row, 0) = x;
  particles.position(row, 1) = y;
}

}  // namespace barreno::testing
