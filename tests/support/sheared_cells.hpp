// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno::testing {

/// Two tiles with four particles in one cell each, all with the same shear in dt L.
inline State sheared_cells(double shear) {
  State state = start_in_tiles(two_tiles(elastic(1.0, 0.25, 1.0), 2));
  state.dormancy = {};
  Particles& particles = state.particles[0];
  EXPECT_EQ(particles.count, 8);
  for (int p = 0; p < particles.count; ++p) {
    for (int c = 0; c < particles.increment.components; ++c) particles.increment(p, c) = 0.0;
    particles.increment(p, 1) = shear;
  }
  return state;
}
/// The particle k of a tile's cell.
inline int row_in_cell(const Particles& particles, int tile, int k) {
  return particles.order(particles.tile_begin(tile) + k);
}
/// Change of ln V in dt L.
inline double dilatation(const Particles& particles, int p) {
  return particles.increment(p, 0) + particles.increment(p, 3) + particles.increment(p, 4);
}
/// The step of the first tile has not ended.
inline void leave_first_tile(State& state) {
  state.dormancy.on = true;
  state.dormancy.stays = ArrayView<unsigned char>("stays", 2);
  state.dormancy.stays(0) = is_in_its_step;
}

}  // namespace barreno::testing
