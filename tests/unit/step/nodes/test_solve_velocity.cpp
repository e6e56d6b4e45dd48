// SPDX-License-Identifier: BSD-3-Clause
#include "step/grid_tally.hpp"
#include "step/nodes/solve_velocity.hpp"
#include "step/transfer/project_particles.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace barreno {
namespace {

/// One node of each tile with a mass of 2, momentum (4, -2) and force (8, 16).
struct TwoNodes {
  Scene scene;
  State state;
  Nodes& nodes;
  int slot;

  TwoNodes()
      : scene(testing::two_tiles(testing::elastic(1.0, 0.25, 4.0))),
        state(testing::start_in_tiles(scene)),
        nodes(state.nodes[0]),
        slot(testing::slot_of(state.grid.patch, 4, 4)) {
    clear_nodes(state.grid, nodes);
    testing::set_frame(state.grid, 0, 1.0, 0.5);
    testing::set_frame(state.grid, 1, 1.0, 0.25);
    const double sums[] = {2.0, 4.0, -2.0, 8.0, 16.0};
    for (int tile = 0; tile < 2; ++tile)
      for (int i = 0; i < 5; ++i) sums_of(tile)[i] = sums[i];
  }
  double* sums_of(int tile) {
    return &nodes.sums(first_sum(state.grid.patch, tile)) + slot * sum_components;
  }
  const double* motion_of(int tile) const {
    return &nodes.motion(first_motion(state.grid.patch, tile)) + slot * motion_components(2);
  }
  VelocityRule rule(double damping = 0.0) const { return {scene, {}, damping}; }
};

/// v' = v + dt f / m with the step of the tile.
TEST(SolveVelocity, ForcesActOverTheStepOfTheTile) {
  TwoNodes two;
  const GridTally tally = solve_velocity(two.state.grid, two.rule(), {}, two.nodes);
  double kinetic = 0.0, work = 0.0;
  for (int tile = 0; tile < 2; ++tile) {
    const double dt = tile == 0 ? 0.5 : 0.25;
    const double v[] = {2.0 + 4.0 * dt, -1.0 + 8.0 * dt};
    EXPECT_EQ(two.motion_of(tile)[0], v[0]);
    EXPECT_EQ(two.motion_of(tile)[1], v[1]);
    EXPECT_EQ(two.motion_of(tile)[2], 4.0 * dt);
    EXPECT_EQ(two.motion_of(tile)[3], 8.0 * dt);
    kinetic += v[0] * v[0] + v[1] * v[1];
    work += 0.5 * dt * (8.0 * (2.0 + v[0]) + 16.0 * (v[1] - 1.0));
  }
  EXPECT_EQ(tally.kinetic_before, 2.0 * 5.0);
  EXPECT_EQ(tally.kinetic_after, kinetic);
  EXPECT_EQ(tally.force_work, work);
  EXPECT_EQ(tally.force_work, tally.kinetic_after - tally.kinetic_before);
}

TEST(SolveVelocity, DampingTakesMomentum) {
  TwoNodes two;
  const GridTally tally = solve_velocity(two.state.grid, two.rule(0.5), {}, two.nodes);
  EXPECT_EQ(two.motion_of(0)[0], 2.0 + 0.5 * (8.0 - 0.5 * 4.0) / 2.0);
  EXPECT_EQ(two.motion_of(1)[1], -1.0 + 0.25 * (16.0 + 0.5 * 2.0) / 2.0);
  EXPECT_EQ(tally.damping_impulse, 0.5 * 0.5 * 2.0 + 0.25 * 0.5 * 2.0);
}

/// With an impedance Z = m / dt half of the change is left.
TEST(SolveVelocity, AnImpedanceResistsTheChange) {
  TwoNodes two;
  two.sums_of(0)[impedance_component] = 4.0;
  const GridTally tally = solve_velocity(two.state.grid, two.rule(), {}, two.nodes);
  EXPECT_EQ(two.motion_of(0)[2], 0.5 * 4.0 * 0.5);
  EXPECT_EQ(two.motion_of(1)[2], 4.0 * 0.25);
  EXPECT_EQ(tally.absorbed_impulse, -0.5 * 8.0);
}

TEST(SolveVelocity, ConditionsReplaceComponents) {
  TwoNodes two;
  VelocityRule rule = two.rule();
  rule.conditions.count = 1;
  NodeCondition& condition = rule.conditions.list[0];
  condition.axis = 0;
  condition.bound = 4;  // the node of the first tile
  condition.sets[1] = true;
  const GridTally tally = solve_velocity(two.state.grid, rule, {}, two.nodes);
  EXPECT_EQ(two.motion_of(0)[0], 4.0);  // as without
  EXPECT_EQ(two.motion_of(0)[1], 0.0);
  EXPECT_EQ(two.motion_of(0)[3], 0.0);
  EXPECT_EQ(two.motion_of(1)[1], 1.0);
  EXPECT_EQ(tally.condition_impulse, -0.5 * 16.0);
  EXPECT_EQ(tally.filter_impulse, 2.0 * 1.0);
}

/// Nodes of both patches are summed over them, in both tiles with the same bits.
/// Which tile counts a node hangs on the tiles that are active: a condition elsewhere in the tile
/// changes no bit of a node.
TEST(SolveVelocity, AConditionChangesNoBitOfOtherNodes) {
  TwoNodes two;
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  const Patch& patch = two.state.grid.patch;
  for (int tile = 0; tile < 2; ++tile)
    for (int slot = 0; slot < patch.size; ++slot) {
      double* const node = &two.nodes.sums(first_sum(patch, tile)) + slot * sum_components;
      const bool held = tile == 0 && slot % patch.nodes <= patch.reach;
      node[0] = held || slot % 5 == 0 ? 0.0 : 1.5 + u(engine);
      for (int i = 1; i < 5; ++i) node[i] = node[0] > 0.0 ? u(engine) : 0.0;
    }
  const auto solved = [&](const VelocityRule& rule) {
    const GridTally tally = solve_velocity(two.state.grid, rule, {}, two.nodes);
    std::vector<double> all{tally.kinetic_before, tally.kinetic_after, tally.force_work};
    for (std::size_t i = 0; i < first_motion(patch, 2); ++i) all.push_back(two.nodes.motion(i));
    return all;
  };
  VelocityRule touched = two.rule();
  touched.conditions.count = 1;
  touched.conditions.list[0].bound = 0;
  EXPECT_EQ(solved(two.rule()), solved(touched));
}

TEST(SolveVelocity, PartsOfNeighboursAreAdded) {
  TwoNodes two;
  testing::set_frame(two.state.grid, 1, 1.0, 0.5);
  const Patch& patch = two.state.grid.patch;
  const int left = testing::slot_of(patch, 8, 2), right = testing::slot_of(patch, 0, 2);
  const auto sums = [&](int tile, int slot) {
    return &two.nodes.sums(first_sum(patch, tile)) + slot * sum_components;
  };
  sums(0, left)[0] = 1.0;
  sums(0, left)[1] = 3.0;
  sums(1, right)[0] = 0.5;
  sums(1, right)[1] = -1.5;
  solve_velocity(two.state.grid, two.rule(), {}, two.nodes);
  const double* const of_left =
      &two.nodes.motion(first_motion(patch, 0)) + left * motion_components(2);
  const double* const of_right =
      &two.nodes.motion(first_motion(patch, 1)) + right * motion_components(2);
  EXPECT_EQ(of_left[0], 1.5 * (1.0 / 1.5));
  EXPECT_EQ(of_right[0], of_left[0]);
}

}  // namespace
}  // namespace barreno
