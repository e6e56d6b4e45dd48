// SPDX-License-Identifier: BSD-3-Clause
// Every transfer in every order of the step, with every shape function in every mode: what all of
// them keep.
#include "base/gather.hpp"
#include "output/reactions.hpp"
#include "state/balance.hpp"
#include "support/expect_same_alone.hpp"
#include "support/scenes.hpp"
#include "unit/step/transfer_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::all_shapes;
using testing::all_steps;
using testing::expect_same_alone;
using testing::is_alone;
using testing::start;
using testing::StepCase;
using testing::steps_in_turn;

/// An elastic box away from all walls.
Scene free_box(Mode mode, const StepSpec& step) {
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.024, 0.008}, testing::elastic(70e9, 0.3, 2700.0)
  );
  scene.step = step;
  add_box(scene, "box", {0.0034, 0.0077, 0.0021}, {0.0085, 0.0149, 0.0049}, 2).velocity = {
      mode == Mode::axisymmetric ? 0.0 : 40.0, 120.0, -30.0};
  return scene;
}

/// Three dimensions take longer.
long steps_in(Mode mode, long steps) {
  return mode == Mode::three_dimensional ? steps / 3 : steps;
}

/// Gives every particle a velocity of its own beside that of the body.
void shake(State& state) {
  for (Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      for (int d = 0; d < particles.velocity.components; ++d) {
        const double id = static_cast<double>(particles.id(static_cast<std::size_t>(p)));
        particles.velocity(p, d) += 25.0 * std::sin(1.7 * id + 2.3 * d);
      }
}

/// Momentum of all particles, and the sum of its parts' sizes.
std::vector<double> momentum(const State& state) {
  std::vector<double> sum(4, 0.0);
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      for (int d = 0; d < particles.velocity.components; ++d) {
        const double part = particles.mass(p) * particles.velocity(p, d);
        sum[static_cast<std::size_t>(d)] += part;
        sum[3] += std::abs(part);
      }
  sum_over_ranks(*state.grid.comm, sum);
  return sum;
}

class Transfers : public ::testing::TestWithParam<Mode> {};

TEST_P(Transfers, KeepMomentumInFreeFlight) {
  for (const std::string& shape : all_shapes())
    for (const StepCase& one : all_steps(shape)) {
      SCOPED_TRACE(one.name);
      const Scene scene = free_box(GetParam(), one.step);
      State state = start(scene);
      shake(state);
      const std::vector<double> before = momentum(state);
      advance_to(scene, 1.0, state, steps_in(GetParam(), 12));
      const std::vector<double> after = momentum(state);
      // Around the axis radial momentum is none.
      for (std::size_t d = GetParam() == Mode::axisymmetric ? 1 : 0; d < 3; ++d)
        EXPECT_NEAR(after[d], before[d], 2e-14 * before[3]);
    }
}

TEST_P(Transfers, ReproduceAUniformVelocity) {
  for (const std::string& shape : all_shapes())
    for (const StepCase& one : all_steps(shape)) {
      SCOPED_TRACE(one.name);
      const Scene scene = free_box(GetParam(), one.step);
      State state = start(scene);
      advance_to(scene, 1.0, state, steps_in(GetParam(), 12));
      const double x = GetParam() == Mode::axisymmetric ? 0.0 : 40.0;
      // Nodes with next to no mass divide round-off by it.
      const double most = 120.0 * (shape == "linear" ? 1e-9 : 1e-13);
      for (const auto& row : all_rows(state)) {
        EXPECT_NEAR(row[2], x, most);
        EXPECT_NEAR(row[3], 120.0, most);
        EXPECT_NEAR(row[8], 1.0, most);
      }
    }
}

TEST_P(Transfers, AnyRankCountGivesTheSameBits) {
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  int turn = 0;
  for (const char* shape : {"GIMP", "CPDI"})
    for (const StepCase& one : steps_in_turn(shape, turn++)) {
      SCOPED_TRACE(one.name);
      Scene scene = free_box(GetParam(), one.step);
      add_symmetry(scene, Face::y_lower);
      scene.bodies[0].velocity[1] = -1500.0;
      expect_same_alone(scene, [&](State& state) {
        shake(state);
        advance_to(scene, 1.0, state, 12);
      });
    }
}

/// A block between a wall, a block of another field that slides on it, and a rigid punch.
Scene pressed(Mode mode, const StepSpec& step) {
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.024, 0.008}, testing::elastic(70e9, 0.3, 2700.0)
  );
  scene.step = step;
  scene.materials.push_back(scene.materials[0]);
  scene.materials.push_back(scene.materials[0]);
  add_box(scene, "low", {0.0, 0.0, 0.0}, {0.0071, 0.0049, 0.004}, 2).velocity = {0, -10, 0};
  BodySpec& high = add_box(scene, "high", {0.0, 0.00492, 0.0}, {0.0052, 0.0099, 0.003}, 2);
  high.material = 1;
  high.velocity = {0, -60, 0};
  BodySpec& punch = add_box(scene, "punch", {0.0, 0.009901, 0.0}, {0.0041, 0.0131, 0.003}, 2);
  punch.material = 2;
  punch.motion.prescribed = true;
  punch.motion.velocity = {0.0, -80.0, 0.0};
  scene.contacts.push_back({"blocks", {0, 1}, ContactKind::friction, 0.3});
  scene.contacts.push_back({"punch", {1, 2}, ContactKind::frictionless, 0.0});
  for (const Face face : {Face::x_lower, Face::y_lower}) add_symmetry(scene, face);
  if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
  return scene;
}

TEST_P(Transfers, BalanceAtWallsContactsAndRigidBodies) {
  const bool space = GetParam() == Mode::three_dimensional;  // where contact takes long
  const std::vector<std::string> few{"GIMP", "CPDI"};
  int turn = static_cast<int>(GetParam());
  for (const std::string& shape : space ? few : all_shapes())
    for (const StepCase& one : steps_in_turn(shape, turn++)) {
      SCOPED_TRACE(one.name);
      const Scene scene = pressed(GetParam(), one.step);
      State state = start(scene);
      advance_to(scene, 1.0, state, space ? 4 : 30);
      const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
      EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
      EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
      EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
      EXPECT_LT(ledger.rigid_impulse, 0.0);
      EXPECT_GT(ledger.condition_impulse, 0.0);
    }
}

/// And the impulses on rigid bodies, as one more row.
std::vector<std::vector<double>> rows_and_reactions(const State& state) {
  std::vector<std::vector<double>> out = all_rows(state);
  out.push_back(reaction_impulses(state));
  return out;
}

TEST_P(Transfers, AnyRankCountGivesTheSameBitsAtContactsAndRigidBodies) {
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  for (const StepCase& one : steps_in_turn("GIMP", static_cast<int>(GetParam()))) {
    SCOPED_TRACE(one.name);
    const Scene scene = pressed(GetParam(), one.step);
    const auto run = [&](State& state) {
      advance_to(scene, 1.0, state, steps_in(GetParam(), 12));
      EXPECT_GT(reaction_impulses(state)[GetParam() == Mode::axisymmetric ? 0 : 1], 0.0);
    };
    expect_same_alone(scene, run, rows_and_reactions);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, Transfers, ::testing::ValuesIn(all_modes));

}  // namespace
}  // namespace barreno
