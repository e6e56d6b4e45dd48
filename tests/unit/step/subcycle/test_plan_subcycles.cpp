// SPDX-License-Identifier: BSD-3-Clause
// How many parts of a step tiles take at once.
#include "step/stable_step.hpp"
#include "step/subcycle/plan_subcycles.hpp"
#include "step/subcycle/reached_tiles.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace barreno {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// Three tiles of 8 x 8 cells of size 1 along x; sound takes a time of 1 through a cell of the
/// first and of 6 through one of the others.
Scene three_tiles() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {24.0, 8.0}, testing::elastic(1.0, 0.0, 1.0)
  );
  scene.materials.push_back(testing::elastic(1.0 / 36.0, 0.0, 1.0));
  testing::add_box(scene, "stiff", {0.0, 0.0}, {8.0, 8.0}, 2);
  testing::add_box(scene, "soft", {8.0, 0.0}, {24.0, 8.0}, 2).material = 1;
  scene.step.subcycles = 8;
  return scene;
}

/// The step that the stiff tile bears.
double least_step(const Scene& scene, const State& state) {
  return stable_step_of_rows(scene.step, state.grid, state.particles[0], 0);
}

bool plan(const Scene& scene, double dt, double left, State& state) {
  state.subcycling.most = scene.step.subcycles;
  return plan_subcycles(
      scene.step, state.grid, state.particles, state.dormancy, dt, left, state.subcycling
  );
}

TEST(PlanSubcycles, ATileTakesThePowerOfTwoThatItsStepHolds) {
  const Scene scene = three_tiles();
  State state = testing::in_tiles(scene, 0.0);
  plan(scene, least_step(scene, state), forever, state);
  EXPECT_EQ(state.subcycling.parts, 8);
  EXPECT_EQ(state.subcycling.period(0), 1);
  EXPECT_EQ(state.subcycling.period(1), 4);
  EXPECT_EQ(state.subcycling.period(2), 4);
}

TEST(PlanSubcycles, ThePartsFitIntoTheTimeThatIsLeft) {
  const Scene scene = three_tiles();
  State state = testing::in_tiles(scene, 0.0);
  const double dt = least_step(scene, state);
  plan(scene, dt, 3.9 * dt, state);
  EXPECT_EQ(state.subcycling.parts, 2);
  EXPECT_EQ(state.subcycling.period(2), 2);
  plan(scene, dt, 1.9 * dt, state);
  EXPECT_FALSE(state.subcycling.on());
}

/// A particle of the stiff tile that may cross the border while the next tile is within its step
/// has that tile step as fast; one that moves along the border does not.
TEST(PlanSubcycles, ATileFollowsThoseWhoseParticlesMayComeIntoIt) {
  const Scene scene = three_tiles();
  State state = testing::in_tiles(scene, 0.0);
  Particles& stiff = state.particles[0];
  int last = 0;
  for (int p = 0; p < stiff.count; ++p)
    if (stiff.position(p, 0) > 7.7 && stiff.position(p, 1) > 3.0 && stiff.position(p, 1) < 4.0)
      last = p;
  const double dt = least_step(scene, state);
  stiff.velocity(last, 1) = 0.01 / dt;
  plan(scene, dt, forever, state);
  EXPECT_EQ(state.subcycling.period(1), 4);
  stiff.velocity(last, 0) = 0.04 / dt;  // 0.25 of a cell away, in eight parts 0.32: it stays near
  plan(scene, dt, forever, state);
  EXPECT_EQ(state.subcycling.period(1), 4);
  stiff.velocity(last, 0) = 0.05 / dt;
  plan(scene, dt, forever, state);
  EXPECT_EQ(state.subcycling.period(0), 1);
  EXPECT_EQ(state.subcycling.period(1), 1);
  EXPECT_EQ(state.subcycling.period(2), 4);
}

/// Tiles that particles may enter are active before the step begins, whatever was there before:
/// three behind the corner of the block, towards which a particle moves.
TEST(PlanSubcycles, TilesAheadOfParticlesAreAskedFor) {
  Scene scene = three_tiles();
  scene.grid.upper = {24.0, 16.0, 0.0};
  scene.bodies.pop_back();
  State state = testing::in_tiles(scene, 0.0);
  Particles& stiff = state.particles[0];
  int last = 0;
  for (int p = 0; p < stiff.count; ++p)
    if (stiff.position(p, 0) > 7.7 && stiff.position(p, 1) > 7.7) last = p;
  const double dt = least_step(scene, state);
  EXPECT_FALSE(plan(scene, dt, forever, state));
  EXPECT_TRUE(reached_tiles(state.grid, state.subcycling).empty());
  stiff.velocity(last, 0) = stiff.velocity(last, 1) = 0.05 / dt;
  EXPECT_TRUE(plan(scene, dt, forever, state));
  const std::vector<int> reached = reached_tiles(state.grid, state.subcycling);
  EXPECT_EQ(reached, (std::vector<int>{1, 3, 4}));
  ASSERT_EQ(state.grid.active, 1);
  activate_reached_tiles(reached, 0, continuum_of(state));
  EXPECT_EQ(state.grid.active, 4);
  EXPECT_FALSE(plan(scene, dt, forever, state));
}

TEST(PlanSubcycles, OneStepForAllIsOnePart) {
  Scene scene = three_tiles();
  scene.step.subcycles = 1;
  State state = testing::in_tiles(scene, 0.0);
  plan(scene, least_step(scene, state), forever, state);
  EXPECT_FALSE(state.subcycling.on());
  EXPECT_FALSE(goes_on(state.subcycling));
}

}  // namespace
}  // namespace barreno
