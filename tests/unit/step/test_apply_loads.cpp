// SPDX-License-Identifier: BSD-3-Clause
// All loads of a scene on the nodes of one particle, and their work.
#include "step/apply_loads.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

constexpr double h = 0.5, weight = 1000.0 * h * h * 8.0, push = 4e6 * h;

/// A particle that fills the cell (3, 3): pressed from above, and pulled down by 8.
Scene pressed_stone() {
  Scene scene = testing::box_scene(
      Mode::plane_strain,
      h,
      {0.0, 0.0, 0.0},
      {8.0 * h, 8.0 * h, 0.0},
      testing::elastic(1e9, 0.25, 1000.0)
  );
  scene.step.shape = "linear";
  testing::add_box(scene, "stone", {3.0 * h, 3.0 * h, 0.0}, {4.0 * h, 4.0 * h, 0.0}, 1);
  PressureLoadSpec load;
  load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
  load.pressure = {{0.0}, {4e6}};
  scene.loads.push_back(load);
  scene.body_force.kind = BodyForceKind::gravity;
  scene.body_force.acceleration = {0.0, -8.0, 0.0};
  return scene;
}

TEST(ApplyLoads, PressureAndBodyForceAddUpAtTheNodes) {
  const Scene scene = pressed_stone();
  State state = testing::in_tiles(scene, 1.0);
  apply_loads(forces_of(scene), state);
  for (const int x : {3, 4}) {
    const auto force = [&](int y) {
      return testing::sums_at(state, 0, 0, {x, y})[first_force(2) + 1];
    };
    EXPECT_DOUBLE_EQ(force(4), -push / 2.0 - weight / 4.0);
    EXPECT_DOUBLE_EQ(force(3), -weight / 4.0);
  }
  EXPECT_EQ(state.ledger.unloaded.value(), 0.0);
}

/// Debris has no surface: what is held keeps its weight and loses its pressure.
TEST(ApplyLoads, ATornFaceIsCountedAndPressedNoMore) {
  const Scene scene = pressed_stone();
  State state = testing::in_tiles(scene, 1.0);
  state.particles[0].deformation_gradient(0, 0) = 2.5;
  apply_loads(forces_of(scene), state);
  EXPECT_EQ(state.ledger.unloaded.value(), 1.0);
  EXPECT_DOUBLE_EQ(testing::sums_at(state, 0, 0, {3, 4})[first_force(2) + 1], -weight / 4.0);
}

/// Force times the mean velocity, 3, times the step.
TEST(TallyAppliedLoads, IsTheWorkOfAllOfThem) {
  const Scene scene = pressed_stone();
  State state = testing::in_tiles(scene, 0.125);
  apply_loads(forces_of(scene), state);
  testing::set_motion(state, {7.0, 5.0, 0.0}, {2.0, 4.0, 0.0});
  const double motion[] = {7.0, 5.0, 2.0, 4.0};
  for (int c = 0; c < 4; ++c) state.particles[0].grid_motion(0, c) = motion[c];
  const double work = tally_applied_loads(scene.body_force, state);
  EXPECT_DOUBLE_EQ(work, -(push + weight) * 3.0 * 0.125);
  EXPECT_DOUBLE_EQ(state.ledger.load_impulse.value(), -push * 0.125);
}

}  // namespace
}  // namespace barreno
