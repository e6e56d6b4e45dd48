// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "step/ranks/place_particles.hpp"
#include "support/scenes.hpp"

namespace barreno::testing {

/// A plane strain box of two tiles side by side along x, with cells of size 1, and in the middle of
/// cell (3, 3) of each tile a body of that one cell.
inline Scene two_tiles(const MaterialSpec& material, int particles_per_cell = 1) {
  Scene scene = box_scene(Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {16.0, 8.0, 0.0}, material);
  add_box(scene, "left", {3.0, 3.0, 0.0}, {4.0, 4.0, 0.0}, particles_per_cell);
  add_box(scene, "right", {11.0, 3.0, 0.0}, {12.0, 4.0, 0.0}, particles_per_cell);
  return scene;
}

/// The state at the start on this rank alone, its particles in their tiles.
inline State start_in_tiles(const Scene& scene) {
  State state = start_alone(scene);
  Placement placement = locate_particles(continuum_of(state));
  placement.new_tile = true;
  place_particles(placement, 0, continuum_of(state));
  return state;
}

/// Cell size and step of one tile, which refined tiles and steps of their own will differ in.
inline void set_frame(const Grid& grid, int tile, double cell_size, double dt) {
  grid.tile_frame(tile).cell_size = cell_size;
  grid.tile_frame(tile).dt = grid.tile_frame(tile).part = dt;
}

/// The one row of a tile, of bodies of one particle.
inline int row_in(const Particles& particles, int tile) {
  return particles.order(particles.tile_begin(tile));
}

inline Rows all_rows_of(const Particles& particles) {
  return {0, particles.count};
}

/// Slot of the node (x, y) of a tile's own cells in its patch.
inline int slot_of(const Patch& patch, int x, int y) {
  return (y + patch.reach) * patch.nodes + x + patch.reach;
}

}  // namespace barreno::testing
