// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/tiles.hpp"

namespace barreno::testing {

inline constexpr double h = 0.5, density = 1000.0, young = 8e9, poisson = 0.25;
inline const double axial = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
inline const double shear = young / (2.0 * (1.0 + poisson));

/// Single particles that fill the cells (3, 3) and (3, 11): one in each of two tiles.
inline Scene two_particles(LoadKind kind, Face face, double pressure) {
  Scene scene = box_scene(
      Mode::plane_strain,
      h,
      {0.0, 0.0, 0.0},
      {8.0 * h, 16.0 * h, 0.0},
      elastic(young, poisson, density)
  );
  scene.step.shape = "linear";
  for (int i = 0; i < 2; ++i) {
    const double y = (3.0 + 8.0 * i) * h;
    add_box(scene, "block", {3.0 * h, y, 0.0}, {4.0 * h, y + h, 0.0}, 1).velocity = {3.0, 2.0, 0.0};
    PressureLoadSpec load;
    load.body = i;
    load.kind = kind;
    load.faces[static_cast<std::size_t>(face)] = true;
    load.pressure = {{0.0}, {pressure}};
    scene.loads.push_back(load);
  }
  return scene;
}

}  // namespace barreno::testing
