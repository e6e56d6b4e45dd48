// SPDX-License-Identifier: BSD-3-Clause
// Particles of a rigid body move as it is prescribed, each by the step of its tile.
#include "state/rigid_motions.hpp"
#include "step/boundary/move_rigid_particles.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace barreno {
namespace {

/// Two particles of one rigid body, in two tiles.
Scene rod(const Vector& velocity) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {16.0, 8.0, 0.0}, testing::elastic(1e9, 0.3, 1e3)
  );
  BodySpec& body = testing::add_box(scene, "rod", {7.0, 3.0, 0.0}, {9.0, 4.0, 0.0}, 1);
  body.motion.prescribed = true;
  body.motion.velocity = velocity;
  body.motion.factor = {{0.0, 1.0}, {0.0, 1.0}};
  return scene;
}

TEST(MoveRigidParticles, EveryTileTakesItsOwnStep) {
  State state = testing::in_tiles(rod({3.0, -4.0, 0.0}), 0.5);
  ASSERT_EQ(state.grid.active, 2);
  testing::set_tile_step(state.grid, 1, 0.25);
  Particles& particles = state.particles[0];
  const double least = move_rigid_particles(state.rigid_motions, 0.5, state.grid, particles);
  for (int tile = 0; tile < 2; ++tile) {
    const double dt = tile == 0 ? 0.5 : 0.25, factor = 0.5 + 0.5 * dt;
    ASSERT_EQ(particles.tile_begin(tile + 1) - particles.tile_begin(tile), 1);
    const int p = particles.order(particles.tile_begin(tile));
    EXPECT_EQ(particles.velocity(p, 0), 3.0 * factor);
    EXPECT_EQ(particles.velocity(p, 1), -4.0 * factor);
    EXPECT_EQ(particles.position(p, 0), 7.5 + tile + dt * 3.0 * factor);
    EXPECT_EQ(particles.position(p, 1), 3.5 - dt * 4.0 * factor);
  }
  EXPECT_EQ(least, 0.5 / (5.0 * 0.75));  // of the faster one, half a cell
}

TEST(RigidMotions, VelocityIsThatOfTheMiddleOfTheStep) {
  const State state = testing::in_tiles(rod({2.0, -1.0, 0.5}), 0.5);
  double v[3];
  state.rigid_motions.over_step(0, 0.25, 0.5, v);
  EXPECT_EQ(v[0], 1.0);
  EXPECT_EQ(v[1], -0.5);
  EXPECT_EQ(v[2], 0.25);
}

TEST(MoveRigidParticles, OnesThatRestAllowAnyStep) {
  State state = testing::in_tiles(rod({0.0, 0.0, 0.0}), 0.5);
  EXPECT_EQ(
      move_rigid_particles(state.rigid_motions, 0.0, state.grid, state.particles[0]),
      std::numeric_limits<double>::infinity()
  );
  EXPECT_EQ(state.particles[0].velocity(0, 1), 0.0);
}

}  // namespace
}  // namespace barreno
