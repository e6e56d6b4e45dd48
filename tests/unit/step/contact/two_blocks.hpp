// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/contact/detect_contact_nodes.hpp"
#include "step/contact/fit_surface_normals.hpp"
#include "step/contact/refine_surface_normals.hpp"
#include "support/tiles.hpp"

#include <vector>

namespace barreno::testing {

/// Two blocks of two materials beside each other in one tile, cells of size h: of 2 x 4 cells, the
/// second begins `gap` cells to the right of the first, which ends at x = 4.
inline Scene two_blocks(Mode mode, double h, double gap, ContactKind kind, double friction = 0.0) {
  Scene scene =
      box_scene(mode, h, {0.0, 0.0, 0.0}, {8.0 * h, 8.0 * h, 8.0 * h}, elastic(1e9, 0.3, 1e3));
  scene.materials.push_back(scene.materials[0]);
  const double depth = mode == Mode::three_dimensional ? 6.0 * h : 0.0;
  const double front = mode == Mode::three_dimensional ? 2.0 * h : 0.0;
  add_box(scene, "left", {2.0 * h, 2.0 * h, front}, {4.0 * h, 6.0 * h, depth}, 2);
  const double begin = (4.0 + gap) * h;
  add_box(scene, "right", {begin, 2.0 * h, front}, {begin + 2.0 * h, 6.0 * h, depth}, 2).material =
      1;
  scene.contacts.push_back({"contact", {0, 1}, kind, friction});
  return scene;
}

/// Masses of all particles on the nodes, and where fields meet.
inline void meet(const Scene& scene, State& state) {
  for (const Particles& particles : state.particles)
    project_particles(
        state.grid, particles, state.nodes[static_cast<std::size_t>(particles.field)]
    );
  detect_contact_nodes(state.grid, state.fields, state.particles, state.nodes, state.contact);
  const SymmetryPlanes planes(scene.conditions, state.grid);
  fit_surface_normals({state.grid, state.fields, state.particles, planes}, state.contact);
}

/// The normal of a pair at a node of the box, and the gap behind it.
inline double* normal_at(
    const State& state, int tile, const std::vector<int>& node, std::size_t pair = 0
) {
  const int components = normal_components(state.grid.patch.dimensions);
  return &state.contact.normal[pair](first_value(state.grid.patch, tile, components)) +
         slot_of(state.grid, tile, node) * components;
}

}  // namespace barreno::testing
