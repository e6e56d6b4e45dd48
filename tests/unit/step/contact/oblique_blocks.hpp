// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/scenes.hpp"

namespace barreno::testing {

/// Edges of two blocks and of a third beside the upper one; they end where the faces of the blocks
/// are not those of cells.
struct ObliqueBlocks {
  Box low{{0.004, 0.006, 0.0021}, {0.0123, 0.0179, 0.0047}};
  Box high{{0.003, 0.020, 0.0026}, {0.0101, 0.0307, 0.0051}};
  Box beside{{0.0101, 0.020, 0.0026}, {0.0150, 0.0307, 0.0051}};
};

/// A block that hits another aslant, with friction; a third of yet another material joins the
/// second. In three dimensions they slide past each other along z too.
/// @param upper_count  particles per cell of the upper one
inline Scene oblique_blocks(
    Mode mode, double h, int upper_count, const ObliqueBlocks& blocks = {}
) {
  Scene scene =
      box_scene(mode, h, {0.0, 0.0, 0.0}, {0.024, 0.040, 0.008}, elastic(70e9, 0.3, 2700.0));
  scene.materials.push_back(scene.materials[0]);
  scene.materials.push_back(elastic(20e9, 0.2, 2700.0));
  scene.materials.back().bad_particles = BadParticlePolicy::stop;
  add_box(scene, "low", blocks.low.lower, blocks.low.upper, 2).velocity = {30.0, 120.0, 25.0};
  add_box(scene, "high", blocks.high.lower, blocks.high.upper, upper_count).velocity = {
      -20.0, -80.0, 0.0};
  add_box(scene, "beside", blocks.beside.lower, blocks.beside.upper, 2).velocity = {
      -20.0, -80.0, 0.0};
  scene.bodies[1].material = 1;
  scene.bodies[2].material = 2;
  scene.contacts.push_back({"faces", {0, 1}, ContactKind::friction, 0.3});
  scene.contacts.push_back({"others", {2, 0}, ContactKind::frictionless, 0.0});
  add_symmetry(scene, Face::x_lower);
  return scene;
}

}  // namespace barreno::testing
