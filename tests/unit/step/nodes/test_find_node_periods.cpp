// SPDX-License-Identifier: BSD-3-Clause
// How many parts of a step nodes take at once, and that those which take several do what they would
// do one by one.
#include "scene/tile_levels.hpp"
#include "state/balance.hpp"
#include "step/apply_loads.hpp"
#include "step/dormant/find_dormant_tiles.hpp"
#include "step/end_part.hpp"
#include "step/nodes/find_node_periods.hpp"
#include "step/nodes/sum_halos.hpp"
#include "step/prepare_step.hpp"
#include "step/solve_motion.hpp"
#include "step/subcycle/plan_subcycles.hpp"
#include "step/subcycle/reached_tiles.hpp"
#include "step/subcycle/tile_steps.hpp"
#include "step/transfer/project_sets.hpp"
#include "step/update_sets.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// A stiff tile of 8 x 8 cells and soft ones beside it along x, which bear four of its steps.
Scene row_of_tiles(double end_of_soft) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {32.0, 8.0}, testing::elastic(1.0, 0.0, 1.0)
  );
  scene.materials.push_back(testing::elastic(1.0 / 36.0, 0.0, 1.0));
  testing::add_box(scene, "stiff", {0.0, 0.0}, {8.0, 8.0}, 2);
  testing::add_box(scene, "soft", {8.0, 0.0}, {end_of_soft, 8.0}, 2).material = 1;
  scene.step.subcycles = 4;
  return scene;
}

class NodePeriods : public ::testing::Test {
protected:
  /// Plans a step of four parts for the particles as they are.
  void plan(const Scene& scene) {
    state.subcycling.most = scene.step.subcycles;
    while (plan_subcycles(
        scene.step, state.grid, state.particles, state.dormancy, 0.6, forever, state.subcycling
    ))
      activate_reached_tiles(reached_tiles(state.grid, state.subcycling), 0, continuum_of(state));
    find_node_periods(
        SymmetryPlanes(scene.conditions, state.grid),
        state.conditions,
        state.grid,
        state.particles,
        state.subcycling
    );
  }
  void start(const Scene& scene) {
    state = testing::in_tiles(scene, 0.6);
    plan(scene);
  }
  int at(int tile, const std::vector<int>& node) const {
    return state.subcycling.node_period(
        tile * state.grid.patch.size + testing::slot_of(state.grid, tile, node)
    );
  }
  State state;
};

TEST_F(NodePeriods, ANodeThatTilesOfOnePeriodHoldTakesItsPartsAtOnce) {
  start(row_of_tiles(24.0));
  ASSERT_EQ(state.subcycling.period(0), 1);
  ASSERT_EQ(state.subcycling.period(1), 4);
  ASSERT_EQ(state.subcycling.period(2), 4);
  for (const int x : {7, 8, 9}) {
    EXPECT_EQ(at(0, {x, 4}), 1);
    EXPECT_EQ(at(1, {x, 4}), 1);
  }
  EXPECT_EQ(at(1, {10, 4}), 4);
  for (const int x : {15, 16, 17}) {
    EXPECT_EQ(at(1, {x, 4}), 4);
    EXPECT_EQ(at(2, {x, 4}), 4);
  }
  EXPECT_EQ(state.subcycling.node_periods(0), 1);
  EXPECT_EQ(state.subcycling.node_periods(1), 1 | 4);
  EXPECT_EQ(state.subcycling.node_periods(2), 4);
  EXPECT_TRUE(state.subcycling.is_steady(2));
}

/// Whether such a tile is active depends on earlier steps.
TEST_F(NodePeriods, ATileWithoutParticlesHasNoSay) {
  const Scene scene = row_of_tiles(8.0 + 8.0);
  start(scene);
  activate_reached_tiles({2, 3}, 0, continuum_of(state));
  ASSERT_EQ(state.grid.active, 4);
  plan(scene);
  state.subcycling.period(2) = 2;
  find_node_periods(
      SymmetryPlanes(scene.conditions, state.grid),
      state.conditions,
      state.grid,
      state.particles,
      state.subcycling
  );
  for (const int x : {15, 16, 17}) {
    EXPECT_EQ(at(1, {x, 4}), 4);
    EXPECT_EQ(at(2, {x, 4}), 4);
  }
}

/// Particles come into it before the step is over, and then its nodes have other masses.
TEST_F(NodePeriods, ATileThatParticlesMayEnterHas) {
  const Scene scene = row_of_tiles(8.0 + 8.0);
  start(scene);
  Particles& soft = state.particles[1];
  for (int p = 0; p < soft.count; ++p)
    if (soft.position(p, 0) > 15.5) soft.velocity(p, 0) = 0.5;
  plan(scene);
  ASSERT_EQ(state.grid.active, 3);
  ASSERT_EQ(state.subcycling.period(2), state.subcycling.period(1));
  state.subcycling.period(2) = 2;
  find_node_periods(
      SymmetryPlanes(scene.conditions, state.grid),
      state.conditions,
      state.grid,
      state.particles,
      state.subcycling
  );
  EXPECT_EQ(at(1, {16, 4}), 1);
  EXPECT_EQ(at(2, {16, 4}), 1);
}

TEST_F(NodePeriods, ANodeThatAConditionMovesInTimeTakesEveryPart) {
  const Scene scene = row_of_tiles(32.0);
  start(scene);
  NodeConditions& conditions = state.conditions;
  NodeCondition& moved = conditions.list[conditions.count++];
  moved.axis = 0;
  moved.bound = 32;
  moved.lower = false;
  moved.sets[0] = true;
  moved.table = 0;
  plan(scene);
  EXPECT_EQ(at(3, {31, 4}), 4);
  EXPECT_EQ(at(3, {32, 4}), 1);
  EXPECT_EQ(at(3, {33, 4}), 1);
}

/// The right part has cells half as wide; the tile of larger ones around them is as slow as they
/// are.
TEST_F(NodePeriods, ANodeThatFollowsTheCoarserLatticeTakesTheStepOfTheCoarserTile) {
  Scene scene = row_of_tiles(24.0);
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {{Box{{17.0, 1.0}, {23.0, 7.0}}, 1}});
  start(scene);
  const int fine = state.grid.first_of_level[1];
  const int coarse = state.grid.parent(fine);
  ASSERT_EQ(state.subcycling.period(fine), 2);
  state.subcycling.period(coarse) = 1;
  find_node_periods(
      SymmetryPlanes(scene.conditions, state.grid),
      state.conditions,
      state.grid,
      state.particles,
      state.subcycling
  );
  EXPECT_EQ(at(fine, {36, 4}), 1);  // even: a node of the coarser lattice
  EXPECT_EQ(at(fine, {37, 4}), 2);
}

/// A stiff body whose waves are five times as fast as those of the soft one that it meets, under
/// pressure from outside.
Scene collision(Mode mode, bool refined) {
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.032, 0.064, 0.012}, testing::elastic(200e9, 0.3, 2700.0)
  );
  scene.materials.push_back(testing::elastic(8e9, 0.2, 2700.0));
  const double width = mode == Mode::three_dimensional ? 0.0083 : 0.0203;
  testing::add_box(scene, "stiff", {0.0, 0.007, 0.0}, {width, 0.0149, 0.0042}, 2).velocity = {
      0, 100, 0};
  BodySpec& soft = testing::add_box(scene, "soft", {0.0, 0.0152, 0.0}, {width, 0.0427, 0.0053}, 2);
  soft.velocity = {0, -20, 0};
  soft.material = 1;
  PressureLoadSpec load;
  load.body = 1;
  load.faces[static_cast<std::size_t>(Face::x_upper)] = true;
  load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
  load.pressure = {{0.0}, {70e6}};
  scene.loads.push_back(load);
  testing::add_symmetry(scene, Face::x_lower);
  if (mode == Mode::three_dimensional) testing::add_symmetry(scene, Face::z_lower);
  if (refined) {
    const RefinedRegion region{Box{{0.0, 0.017, 0.0}, {0.016, 0.0309, 0.008}}, 1};
    scene.grid.level_of_tile = find_tile_levels(scene.grid, {region});
  }
  scene.step.subcycles = 4;
  return scene;
}

void solve_all_in_every_part(const State& state) {
  const Subcycling& of = state.subcycling;
  for (int tile = 0; tile < state.grid.active; ++tile) {
    of.node_periods(tile) = 1;
    for (int slot = 0; slot < state.grid.patch.size; ++slot)
      of.node_period(tile * state.grid.patch.size + slot) = 1;
  }
}

/// What the nodes did in a step.
struct Sums {
  double gained = 0.0;  ///< kinetic energy
  double work = 0.0, applied = 0.0;
};

/// One step, part by part as advance takes it.
/// @param last_part  all tiles meet after that
Sums take_step(const Scene& scene, bool in_every_part, int last_part, State& state) {
  double dt = prepare_step(scene, forever, state).dt;
  if (in_every_part) solve_all_in_every_part(state);
  const SymmetryPlanes symmetry(scene.conditions, state.grid);
  Sums sums;
  bool goes = true;
  while (goes) {
    StepTally tally;
    StepResult result;
    start_tile_steps(state.grid, dt, state.subcycling);
    find_dormant_candidates(
        state.grid,
        state.particles,
        state.subcycling,
        state.dormancy,
        state.nodes,
        state.effort,
        0.0
    );
    project_sets(state.grid, state.particles, state.nodes, state.effort);
    apply_loads(forces_of(scene), state);
    sum_halos(symmetry, state.grid, state.nodes);
    solve_motion(scene, dt, state, tally);
    tally.applied_work = tally_applied_loads(scene.body_force, state);
    const double end = state.clock.time + dt;
    update_sets(set_update(scene.materials, scene.step, end, state), tally, result);
    if (state.subcycling.part == last_part) tally.stress.stable_step = 0.0;
    if (goes_on(state.subcycling)) end_or_carry_steps(scene, dt, state, tally, result);
    sums.gained += tally.grid.kinetic_after.value() - tally.grid.kinetic_before.value();
    sums.work += tally.grid.force_work.value();
    sums.applied += tally.applied_work.value();
    state.clock.time = end;
    goes = goes_on(state.subcycling);
    if (goes) prepare_next_part(state);
  }
  return sums;
}

class SteadyNodesOf : public ::testing::TestWithParam<Mode> {
protected:
  /// Takes a step of a collision that is under way both ways, to all of its parts or to one.
  static void expect_alike(const Scene& scene, int last_part) {
    State once = testing::start_alone(scene), every = testing::start_alone(scene);
    testing::advance_to(scene, 1.0, once, 12);
    testing::advance_to(scene, 1.0, every, 12);
    const Sums of_once = take_step(scene, false, last_part, once);
    const Sums of_every = take_step(scene, true, last_part, every);
    ASSERT_EQ(once.subcycling.parts, 4);
    ASSERT_EQ(once.subcycling.part, last_part);
    const auto a = testing::all_rows(once), b = testing::all_rows(every);
    ASSERT_EQ(a.size(), b.size());
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (const std::size_t column : {std::size_t{2}, std::size_t{3}})
        most = std::max(most, std::abs(a[i][column] - b[i][column]));
    EXPECT_EQ(most > 0.0, last_part > 0) << "steps of one part are the same ones";
    EXPECT_LT(most, 1e-12 * 120.0);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i][1], b[i][1], 1e-12 * 1e-3);
    EXPECT_NEAR(of_once.gained, of_every.gained, 1e-11 * std::abs(of_every.gained));
    EXPECT_NEAR(of_once.work, of_every.work, 1e-11 * std::abs(of_every.work));
    EXPECT_NE(of_every.applied, 0.0);
    EXPECT_NEAR(of_once.applied, of_every.applied, 1e-11 * std::abs(of_every.applied));
  }
};

TEST_P(SteadyNodesOf, ThatAreSolvedOnceDoWhatTheyWouldDoPartByPart) {
  testing::on_root([] { expect_alike(collision(GetParam(), false), 3); });
}
TEST_P(SteadyNodesOf, DoSoOnLevels) {
  testing::on_root([] { expect_alike(collision(GetParam(), true), 3); });
}
TEST_P(SteadyNodesOf, DoSoWhereAllTilesMeetEarly) {
  for (const int last_part : {0, 1, 2})
    testing::on_root([&] { expect_alike(collision(GetParam(), last_part != 1), last_part); });
}

INSTANTIATE_TEST_SUITE_P(Modes, SteadyNodesOf, ::testing::ValuesIn(testing::all_modes));

}  // namespace
}  // namespace barreno
