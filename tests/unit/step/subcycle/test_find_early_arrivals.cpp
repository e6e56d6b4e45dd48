// SPDX-License-Identifier: BSD-3-Clause
// Particles that come where they cannot be taken in yet.
#include "base/rows.hpp"
#include "step/subcycle/find_early_arrivals.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace barreno {
namespace {

/// Two tiles side by side and none above; the first takes every part of two, the second both.
class EarlyArrivals : public ::testing::Test {
protected:
  EarlyArrivals() : state(testing::in_tiles(scene(), 1.0)) {
    Subcycling& subcycling = state.subcycling;
    subcycling.parts = 2;
    subcycling.period = ArrayView<int>("period", 2);
    subcycling.ends = ArrayView<unsigned char>("ends", 2);
    subcycling.period(0) = 1;
    subcycling.period(1) = 2;
    subcycling.ends(0) = 1;
    Particles& particles = state.particles[0];
    std::fill_n(particles.chunk_part.data(), particles.chunk_part.extent(0), whole_chunk);
  }
  static Scene scene() {
    Scene scene = testing::box_scene(
        Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 16.0}, testing::elastic(1e6, 0.3, 1000.0)
    );
    testing::add_box(scene, "block", {0.0, 0.0}, {16.0, 8.0}, 2);
    return scene;
  }
  /// Of a particle of the first tile, which goes to a place.
  bool is_early(double x, double y) {
    Particles& particles = state.particles[0];
    const int p = particles.order(0);
    particles.position(p, 0) = x;
    particles.position(p, 1) = y;
    return find_early_arrivals(state.grid, state.particles, state.subcycling);
  }
  State state;
};

TEST_F(EarlyArrivals, AreThoseInATileWithinItsOwnStep) {
  EXPECT_FALSE(is_early(7.9, 4.0));
  EXPECT_TRUE(is_early(8.1, 4.0));
  state.subcycling.part = 1;  // with which both steps end
  EXPECT_FALSE(is_early(8.1, 4.0));
}

TEST_F(EarlyArrivals, AreThoseWhereNoTileIsButNotThoseThatHaveLeftTheGrid) {
  EXPECT_TRUE(is_early(4.0, 8.1));
  EXPECT_FALSE(is_early(-0.1, 4.0));
}

}  // namespace
}  // namespace barreno
