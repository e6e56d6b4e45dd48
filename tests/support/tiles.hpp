// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/tiles.hpp"
#include "step/ranks/place_particles.hpp"
#include "step/transfer/project_particles.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <vector>

namespace barreno::testing {

/// A scene's particles in their tiles, on this rank alone: what a verb of the step finds. Nodes
/// hold nothing, and every tile takes a step of `dt`.
inline State in_tiles(const Scene& scene, double dt) {
  State state = start_alone(scene);
  state.dormancy.on = false;
  give_parcels(std::vector<int>(state.grid.owner), 1, continuum_of(state));
  set_tile_steps(state.grid, dt);
  for (Nodes& nodes : state.nodes) {
    clear_nodes(state.grid, nodes);
    std::fill_n(nodes.motion.data(), nodes.motion.extent(0), 0.0);
  }
  return state;
}

/// Slot of a node of the box in the patch of a tile.
inline int slot_of(const Grid& grid, int tile, const std::vector<int>& node) {
  const Patch& patch = grid.patch;
  int slot = 0;
  for (int d = patch.dimensions - 1; d >= 0; --d) {
    const int first = grid.tile_frame(tile).position[d] * patch.tile_cells - patch.reach;
    slot = slot * patch.nodes + node[static_cast<std::size_t>(d)] - first;
  }
  return slot;
}

/// Mass, momentum, force and impedance that a tile has at a node of the box.
inline double* sums_at(const State& state, int field, int tile, const std::vector<int>& node) {
  const Nodes& nodes = state.nodes[static_cast<std::size_t>(field)];
  return &nodes.sums(first_sum(state.grid.patch, tile)) +
         slot_of(state.grid, tile, node) * sum_components;
}

/// Velocity after the step, and its increment.
inline double* motion_at(const State& state, int field, int tile, const std::vector<int>& node) {
  const Nodes& nodes = state.nodes[static_cast<std::size_t>(field)];
  return &nodes.motion(first_motion(state.grid.patch, tile)) +
         slot_of(state.grid, tile, node) * motion_components(state.grid.patch.dimensions);
}

/// The velocity and the increment of all nodes of the own tiles.
inline void set_motion(const State& state, const Vector& velocity, const Vector& increment) {
  const int d = state.grid.patch.dimensions, width = motion_components(d);
  for (const Nodes& nodes : state.nodes)
    for (int i = 0; i < state.grid.active * state.grid.patch.size; ++i)
      for (int c = 0; c < d; ++c) {
        nodes.motion(static_cast<std::size_t>(i * width + c)) =
            velocity[static_cast<std::size_t>(c)];
        nodes.motion(static_cast<std::size_t>(i * width + d + c)) =
            increment[static_cast<std::size_t>(c)];
      }
}

/// The step of one tile (TileFrame::dt).
inline void set_tile_step(const Grid& grid, int tile, double dt) {
  grid.tile_frame(tile).dt = grid.tile_frame(tile).part = dt;
}

}  // namespace barreno::testing
