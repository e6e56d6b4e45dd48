// SPDX-License-Identifier: BSD-3-Clause
// The body force of one particle at its nodes; its work and impulse.
#include "step/loads/project_body_force.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

constexpr double h = 0.5, density = 1000.0, weight = density * h * h * 9.0;

/// Particles that fill the cells (3, 3) and (3, 11): one in each of two tiles; they are pulled down
/// by 9 and to the side by 4.
Scene two_particles(int bodies) {
  Scene scene = testing::box_scene(
      Mode::plane_strain,
      h,
      {0.0, 0.0, 0.0},
      {8.0 * h, 16.0 * h, 0.0},
      testing::elastic(1e9, 0.25, density)
  );
  scene.step.shape = "linear";
  for (int i = 0; i < bodies; ++i) {
    const double y = (3.0 + 8.0 * i) * h;
    testing::add_box(scene, "stone", {3.0 * h, y, 0.0}, {4.0 * h, y + h, 0.0}, 1);
  }
  scene.body_force.kind = BodyForceKind::gravity;
  scene.body_force.acceleration = {4.0, -9.0, 0.0};
  return scene;
}

TEST(ProjectBodyForce, IsSharedByTheNodesOfTheCell) {
  const Scene scene = two_particles(2);
  State state = testing::in_tiles(scene, 1.0);
  project_body_force(scene.body_force, state.clock, state.grid, state.particles, state.nodes);
  for (const int x : {3, 4})
    for (const int y : {3, 4}) {
      const double* const node = testing::sums_at(state, 0, 0, {x, y});
      EXPECT_DOUBLE_EQ(node[first_force(2)], weight * 4.0 / 9.0 / 4.0);
      EXPECT_DOUBLE_EQ(node[first_force(2) + 1], -weight / 4.0);
      EXPECT_EQ(node[0], 0.0);
    }
  EXPECT_EQ(testing::sums_at(state, 0, 0, {5, 3})[first_force(2) + 1], 0.0);
}

struct Tallied {
  double work, impulse;
};
/// With grid velocities (1, 5) after an increment of (2, 4) at every particle.
Tallied tally(double dt, double dt_above, int bodies) {
  const Scene scene = two_particles(bodies);
  State state = testing::in_tiles(scene, dt);
  if (bodies == 2) testing::set_tile_step(state.grid, 1, dt_above);
  const double motion[4] = {1.0, 5.0, 2.0, 4.0};
  for (int p = 0; p < state.particles[0].count; ++p)
    for (int c = 0; c < 4; ++c) state.particles[0].grid_motion(p, c) = motion[c];
  const double work =
      tally_body_force(scene.body_force, state.clock, state.grid, state.particles, state.ledger);
  EXPECT_EQ(state.ledger.body_work.value(), work);
  return {work, state.ledger.body_impulse.value()};
}

TEST(TallyBodyForce, IsForceTimesMeanVelocityAndForceOverTheStep) {
  const Tallied found = tally(0.125, 0.125, 1);
  EXPECT_DOUBLE_EQ(found.work, -weight * 3.0 * 0.125);  // along x the mean velocity is 0
  EXPECT_DOUBLE_EQ(found.impulse, -weight * 0.125);
}

TEST(TallyBodyForce, EveryTileTakesItsOwnStep) {
  const Tallied slow = tally(0.125, 0.125, 1), fast = tally(0.03125, 0.03125, 1);
  const Tallied both = tally(0.125, 0.03125, 2);
  EXPECT_DOUBLE_EQ(both.work, slow.work + fast.work);
  EXPECT_DOUBLE_EQ(both.impulse, slow.impulse + fast.impulse);
}

}  // namespace
}  // namespace barreno
