// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/transfer/project_particles.hpp"
#include "support/two_tiles.hpp"

namespace barreno::testing {

/// A particle that fills a cell weighs its four corners alike: D is 1/4 of a square cell along each
/// axis. The second tile has cells half as large, from 4 to 8 along x.
struct TwoCells {
  Scene scene;
  State state;
  Particles& particles;

  TwoCells() : scene(make()), state(start_in_tiles(scene)), particles(state.particles[0]) {
    set_frame(state.grid, 0, 1.0, 0.5);
    set_frame(state.grid, 1, 0.5, 0.5);
    const int fine = row_in(particles, 1);
    particles.position(fine, 0) = 4.0 + 3.5 * 0.5;
    particles.position(fine, 1) = 3.5 * 0.5;
    for (int d = 0; d < 2; ++d) particles.half_size(fine, d) = 0.25;
    clear_nodes(state.grid, state.nodes[0]);
  }
  static Scene make() {
    Scene scene = two_tiles(elastic(1.0, 0.25, 4.0));
    scene.step.transfer = Transfer::apic;
    scene.step.pic_fraction = 1.0;
    return scene;
  }
  static double cell_size(int tile) { return tile == 0 ? 1.0 : 0.5; }
  static double second_moment(int tile) { return 0.25 * cell_size(tile) * cell_size(tile); }
};

/// Velocity gradient of the particles.
inline constexpr double slope[2][2] = {{0.5, 2.0}, {-1.0, 4.0}};

/// The same particles with another transfer, which have no first moments.
inline State without_affine_velocity() {
  State state = start_in_tiles(two_tiles(elastic(1.0, 0.25, 4.0)));
  clear_nodes(state.grid, state.nodes[0]);
  return state;
}

}  // namespace barreno::testing
