// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/tiles.hpp"

#include <vector>

namespace barreno::testing {

/// A particle in the first tile of a box, and one in the tile above it; faces of the box that are
/// planes of symmetry.
inline Scene two_tiles_along_y(const std::vector<Face>& faces) {
  Scene scene =
      box_scene(Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {8.0, 16.0, 0.0}, elastic(1e9, 0.3, 1e3));
  add_box(scene, "low", {3.0, 3.0, 0.0}, {4.0, 4.0, 0.0}, 1);
  add_box(scene, "high", {3.0, 12.0, 0.0}, {4.0, 13.0, 0.0}, 1);
  for (const Face face : faces) add_symmetry(scene, face);
  return scene;
}

}  // namespace barreno::testing
