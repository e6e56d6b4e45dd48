// SPDX-License-Identifier: BSD-3-Clause
// Whole steps in which tiles take steps of their own, on any number of ranks.
#include "base/gather.hpp"
#include "scene/tile_levels.hpp"
#include "state/balance.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::box_scene;
using testing::start;

Scene with_subcycles(Scene scene, int most) {
  scene.step.subcycles = most;
  return scene;
}

/// A stiff body whose waves are five times as fast as those of the soft one that it meets.
Scene collision(Mode mode) {
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.032, 0.064, 0.012}, testing::elastic(200e9, 0.3, 2700.0)
  );
  scene.materials.push_back(testing::elastic(8e9, 0.2, 2700.0));
  const double width = mode == Mode::three_dimensional ? 0.0083 : 0.0203;
  add_box(scene, "stiff", {0.0, 0.007, 0.0}, {width, 0.0149, 0.0042}, 2).velocity = {0, 100, 0};
  BodySpec& soft = add_box(scene, "soft", {0.0, 0.0152, 0.0}, {width, 0.0427, 0.0053}, 2);
  soft.velocity = {0, -20, 0};
  soft.material = 1;
  add_symmetry(scene, Face::x_lower);
  if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
  return scene;
}

Scene refined(Scene scene) {
  const RefinedRegion region{Box{{0.0, 0.008, 0.0}, {0.008, 0.0159, 0.004}}, 1};
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {region});
  return scene;
}

/// A strip that is refined alone, in tiles that are half as large; in space all have that size.
Scene narrowly_refined(Scene scene) {
  const RefinedRegion region{Box{{0.0, 0.0, 0.0}, {0.004, 0.064, 0.004}}, 1};
  scene.grid.level_of_tile = find_cheapest_levels(scene.grid, {region});
  EXPECT_EQ(tile_size_of(scene.grid), 4.0 * scene.grid.cell_size);
  return scene;
}

double particle_steps(const State& state) {
  std::array<double, 1> sum{state.particle_steps};
  sum_over_ranks(*state.grid.comm, sum);
  return sum[0];
}

/// How the particle-steps of all ranks distribute.
StepShares step_shares(const State& state) {
  std::vector<double> sums = values_of(state.step_shares);
  sum_over_ranks(*state.grid.comm, sums);
  return shares_of(sums);
}
template <std::size_t n>
double sum_of(const double (&counts)[n]) {
  return std::accumulate(counts, counts + n, 0.0);
}

/// Root mean square of the difference of axial velocities.
double velocity_difference(const State& one, const State& other) {
  const auto a = all_rows(one), b = all_rows(other);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(a[i][3] - b[i][3], 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

class SubcyclingOf : public ::testing::TestWithParam<Mode> {};

void expect_balances(const State& state) {
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
  EXPECT_GT(ledger.elastic, 0.005 * ledger.initial_kinetic);
}

/// Fewer particle-steps, the same motion but for what halving the step changes too, and balances
/// as exact as with one step for all.
TEST_P(SubcyclingOf, ACollisionKeepsItsBalancesAndNearlyItsMotion) {
  const Scene scene = collision(GetParam()), with = with_subcycles(scene, 4);
  State one_step = start(scene), subcycled = start(with);
  advance_to(scene, 4e-6, one_step);
  advance_to(with, 4e-6, subcycled);
  expect_balances(subcycled);
  EXPECT_LT(subcycled.clock.step, one_step.clock.step / 2);
  EXPECT_LT(particle_steps(subcycled), 0.7 * particle_steps(one_step));
  EXPECT_LT(velocity_difference(one_step, subcycled), 0.01 * 120.0);
}

TEST_P(SubcyclingOf, ACollisionOnLevelsKeepsItsBalancesToo) {
  const Scene scene = refined(collision(GetParam())), with = with_subcycles(scene, 8);
  State one_step = start(scene), subcycled = start(with);
  const double time = GetParam() == Mode::three_dimensional ? 1e-6 : 4e-6;
  advance_to(scene, time, one_step);
  advance_to(with, time, subcycled);
  expect_balances(subcycled);
  EXPECT_LT(particle_steps(subcycled), 0.75 * particle_steps(one_step));
  EXPECT_LT(velocity_difference(one_step, subcycled), 0.01 * 120.0);

  // Tiles are counted whole, and a chunk of rows that reaches into a tile that rests is computed.
  const StepShares shares = step_shares(subcycled);
  EXPECT_EQ(sum_of(shares.of_level), sum_of(shares.of_length));
  EXPECT_LE(sum_of(shares.of_level), particle_steps(subcycled));
  EXPECT_GT(sum_of(shares.of_level), 0.5 * particle_steps(subcycled));
  EXPECT_GT(shares.of_level[0], 0.0);
  EXPECT_GT(shares.of_level[1], shares.of_level[0]);
  EXPECT_GT(shares.of_length[1] + shares.of_length[2] + shares.of_length[3], 0.0);
}

TEST_P(SubcyclingOf, ACollisionOnSmallTilesKeepsItsBalancesToo) {
  const Scene scene = narrowly_refined(collision(GetParam())), with = with_subcycles(scene, 4);
  State one_step = start(scene), subcycled = start(with);
  const double time = GetParam() == Mode::three_dimensional ? 1e-6 : 4e-6;
  advance_to(scene, time, one_step);
  advance_to(with, time, subcycled);
  expect_balances(subcycled);
  EXPECT_LT(particle_steps(subcycled), 0.75 * particle_steps(one_step));
  EXPECT_LT(velocity_difference(one_step, subcycled), 0.01 * 120.0);
}

/// No force arises between tiles of different steps, and each goes as far as its neighbour.
TEST_P(SubcyclingOf, UniformMotionStaysUniform) {
  const Mode mode = GetParam();
  Scene scene = with_subcycles(refined(collision(mode)), 8);
  scene.conditions.clear();
  const double sideways = mode == Mode::axisymmetric ? 0.0 : 30.0;
  for (BodySpec& body : scene.bodies) body.velocity = {sideways, 100.0, 0.0};
  State state = start(scene);
  const auto before = all_rows(state);
  const double time = mode == Mode::three_dimensional ? 1e-6 : 4e-6;
  advance_to(scene, time, state);
  const auto rows = all_rows(state);
  ASSERT_EQ(rows.size(), before.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i][2], sideways, 1e-10);
    EXPECT_NEAR(rows[i][3], 100.0, 1e-10);
    EXPECT_NEAR(rows[i][1], before[i][1] + 100.0 * time, 1e-14);
    EXPECT_NEAR(rows[i][8], 1.0, 1e-12);
  }
}

/// A stiff body on a soft one, pressed from all sides.
Scene preloaded_stack(Mode mode) {
  Scene scene = collision(mode);
  scene.bodies.clear();
  const double width = mode == Mode::three_dimensional ? 0.0083 : 0.0203;
  PressureLoadSpec load;
  load.faces[static_cast<std::size_t>(Face::x_upper)] = true;
  load.faces[static_cast<std::size_t>(Face::z_upper)] = mode == Mode::three_dimensional;
  load.pressure = {{0.0}, {70e6}};
  for (int b = 0; b < 2; ++b) {
    const double lower = b == 0 ? 0.008 : 0.016, upper = b == 0 ? 0.016 : 0.040;
    BodySpec& body =
        add_box(scene, b == 0 ? "stiff" : "soft", {0.0, lower, 0.0}, {width, upper, 0.0053}, 2);
    body.material = b;
    body.initial_pressure = 70e6;
    load.body = b;
    load.faces[static_cast<std::size_t>(Face::y_lower)] = b == 0;
    load.faces[static_cast<std::size_t>(Face::y_upper)] = b == 1;
    scene.loads.push_back(load);
  }
  return scene;
}

/// Under one pressure the discrete equilibrium stays exact. No tile is dormant: nodes may move.
TEST_P(SubcyclingOf, APreloadedStackStaysAtRest) {
  const Mode mode = GetParam();
  Scene scene = with_subcycles(preloaded_stack(mode), 8);
  scene.step.rest_motion = 0.0;
  State state = start(scene);
  advance_to(scene, mode == Mode::three_dimensional ? 1e-6 : 3e-6, state);
  const double free_speed = 70e6 / (2700.0 * std::sqrt(8e9 / 2700.0));
  for (const auto& row : all_rows(state)) EXPECT_LT(std::hypot(row[2], row[3]), 1e-9 * free_speed);
}

/// A soft body let go under pressure beside a stiff one, whose step it does not take.
Scene release(Mode mode) {
  Scene scene = preloaded_stack(mode);
  scene.loads.clear();
  scene.bodies[0].initial_pressure = 0.0;
  auto& [lower, upper] = std::get<Box>(scene.bodies[0].shape);
  lower[1] = 0.050;
  upper[1] = 0.058;
  return scene;
}

/// The method takes energy from a vibration, in steps of several parts as in those of one: without
/// viscosity none could hide that it brings some in.
TEST_P(SubcyclingOf, AFreeVibrationGainsNoEnergy) {
  const Mode mode = GetParam();
  Scene scene = with_subcycles(release(mode), 4);
  scene.step.linear_viscosity = scene.step.quadratic_viscosity = 0.0;
  State state = start(scene);
  advance_to(scene, mode == Mode::three_dimensional ? 20e-6 : 100e-6, state);
  const NumericalEnergy gain = numerical_energy(sum_over_ranks(*state.grid.comm, state.ledger));
  EXPECT_LT(gain.stress_integration, 0.0);
  EXPECT_LT(gain.transfer, 0.0);
  EXPECT_GT(gain.sum(), -0.3);  // with one step for all -0.15
}

INSTANTIATE_TEST_SUITE_P(Modes, SubcyclingOf, ::testing::ValuesIn(all_modes));

/// A run that stops and goes on between steps ends where one does that does not stop.
TEST(Subcycling, NothingOfAStepOutlivesIt) {
  const Scene scene = with_subcycles(collision(Mode::plane_strain), 8);
  State straight = start(scene), stopped = start(scene);
  advance_to(scene, 6e-6, straight);
  advance_to(scene, 6e-6, stopped, 7);
  stopped.subcycling = {};
  stopped.subcycling.most = 8;
  stopped.dormancy.activation = -1;
  advance_to(scene, 6e-6, stopped);
  EXPECT_EQ(velocity_difference(straight, stopped), 0.0);
}

}  // namespace
}  // namespace barreno
