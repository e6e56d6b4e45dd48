// SPDX-License-Identifier: BSD-3-Clause
// Pressures in every order of the step with every transfer and shape function: what all of them
// keep.
#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "state/balance.hpp"
#include "support/expect_same_alone.hpp"
#include "support/scenes.hpp"
#include "unit/step/transfer_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::all_shapes;
using testing::expect_same_alone;
using testing::is_alone;
using testing::start;
using testing::StepCase;
using testing::steps_in_turn;

constexpr double density = 2300.0, pressure = 50e6;
const double free_speed = pressure / (density * std::sqrt(24e9 / density));

Scene empty(Mode mode, const StepSpec& step, double most) {
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {most, 0.020, most}, testing::elastic(20e9, 0.25, density)
  );
  scene.step = step;
  add_symmetry(scene, Face::x_lower);
  if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
  return scene;
}

void press(Scene& scene, LoadKind kind, const std::vector<Face>& faces) {
  PressureLoadSpec load;
  load.kind = kind;
  for (const Face face : faces)
    if (face != Face::z_upper || scene.grid.mode == Mode::three_dimensional)
      load.faces[static_cast<std::size_t>(face)] = true;
  load.pressure = {{0.0}, {pressure}};
  scene.loads.push_back(load);
}

/// What the one point of a particle can integrate: see Loads in docs/method.md 1.
bool averages(const StepSpec& step) {
  return step.shape == "GIMP" || step.shape == "contiguous GIMP" || step.shape == "CPDI";
}
bool rests_on_cells(Mode mode, const StepSpec& step) {
  return averages(step) || step.shape == "linear" ||
         (step.shape == "quadratic B-spline" && mode == Mode::plane_strain);
}
/// Strain from the velocities of nodes with next to no mass, which linear functions have, is the
/// known weakness of stress last; APIC has none of it.
bool is_tame(const StepSpec& step) {
  return step.shape != "linear" || step.order != Order::stress_last ||
         step.transfer == Transfer::apic;
}

/// A block that is pressed all around, one of its faces absorbing; or from below only. Its faces
/// lie on those of cells where one point must do.
Scene block(Mode mode, const StepSpec& step, bool confined) {
  Scene scene = empty(mode, step, 0.008);
  const Vector lower = averages(step) ? Vector{0.0, 0.0042, 0.0} : Vector{0.0, 0.004, 0.0};
  const Vector upper =
      averages(step) ? Vector{0.0047, 0.0112, 0.0033} : Vector{0.005, 0.011, 0.003};
  BodySpec& body = add_box(scene, "block", lower, upper, 2);
  if (confined) body.initial_pressure = pressure;
  press(scene, LoadKind::pressure, {Face::y_lower});
  if (!confined) return scene;
  press(scene, LoadKind::pressure, {Face::y_upper, Face::z_upper});
  press(scene, LoadKind::non_reflecting, {Face::x_upper});
  return scene;
}

/// A hollow ball with a fluid, pressed from outside.
Scene ball(Mode mode, const StepSpec& step, bool confined) {
  Scene scene = empty(mode, step, 0.010);
  BodySpec body;
  body.name = "ball";
  body.shape = Ball{{0.0, 0.0091, 0.0}, 6.1e-3, 2.3e-3};
  body.particles_per_cell = 2;
  if (confined) body.initial_pressure = pressure;
  scene.bodies.push_back(body);
  PressureLoadSpec load;
  load.surfaces = {false, true};
  load.pressure = {{0.0}, {pressure}};
  scene.loads.push_back(load);
  load.kind = LoadKind::pore_fluid;
  load.surfaces = {true, false};
  load.bulk_modulus = 2.2e9;
  load.pressure = {{0.0}, {confined ? pressure : 0.0}};
  scene.loads.push_back(load);
  return scene;
}

/// Three dimensions take longer.
long steps_in(Mode mode) {
  return mode == Mode::three_dimensional ? 4 : 40;
}

template <class Check>
void for_each_step(Mode mode, const Check& check) {
  int turn = static_cast<int>(mode);
  for (const std::string& shape : all_shapes())
    for (const StepCase& one : steps_in_turn(shape, turn++)) {
      SCOPED_TRACE(one.name);
      check(one.step);
    }
}

class LoadOrders : public ::testing::TestWithParam<Mode> {};

TEST_P(LoadOrders, ConfinedBodiesStayAtRest) {
  for_each_step(GetParam(), [&](const StepSpec& step) {
    for (const auto& make : {block, ball}) {
      if (make == block && !rests_on_cells(GetParam(), step)) continue;
      const Scene scene = make(GetParam(), step, true);
      const double most = is_tame(step) ? 1e-9 : 1e-6;
      State state = start(scene);
      const auto before = all_rows(state);
      advance_to(scene, 1.0, state, steps_in(GetParam()));
      const auto after = all_rows(state);
      for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_LT(std::hypot(after[i][2], after[i][3]), most * free_speed);
        for (std::size_t c = 4; c < 8; ++c) EXPECT_NEAR(after[i][c], before[i][c], most * pressure);
      }
    }
  });
}

/// p A t goes into the free block, and all terms of its ledger close.
TEST_P(LoadOrders, ImpulseIsPressureTimesAreaAndTheLedgerCloses) {
  for_each_step(GetParam(), [&](const StepSpec& step) {
    const Scene scene = block(GetParam(), step, false);
    const Vector width = std::get<Box>(scene.bodies[0].shape).upper;  // from planes of symmetry
    const double area = GetParam() == Mode::axisymmetric   ? pi * width[0] * width[0]
                        : GetParam() == Mode::plane_strain ? width[0]
                                                           : width[0] * width[2];
    State state = start(scene);
    advance_to(scene, 1.0, state, steps_in(GetParam()));
    const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
    EXPECT_NEAR(ledger.load_impulse / (pressure * area * state.clock.time), 1.0, 2e-3);
    EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
    if (is_tame(step)) {
      EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-6);
    }
    EXPECT_GT(ledger.boundary_work, 0.0);
  });
}

TEST_P(LoadOrders, SqueezedBallsKeepTheirLedger) {
  for_each_step(GetParam(), [&](const StepSpec& step) {
    const Scene scene = ball(GetParam(), step, false);
    State state = start(scene);
    advance_to(scene, 1.0, state, steps_in(GetParam()));
    const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
    EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
    if (is_tame(step)) {
      EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-6);
    }
    EXPECT_GT(ledger.boundary_work, 0.0);
    EXPECT_GT(std::abs(state.cavities[1].volume / state.cavities[1].initial_volume - 1.0), 1e-6);
  });
}

/// And the volumes of cavities, as one more row.
std::vector<std::vector<double>> rows_and_cavities(const State& state) {
  std::vector<std::vector<double>> out = all_rows(state);
  std::vector<double>& volumes = out.emplace_back();
  for (const auto& cavity : state.cavities) volumes.push_back(cavity.volume);
  return out;
}

TEST_P(LoadOrders, AnyRankCountGivesTheSameBits) {
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  for_each_step(GetParam(), [&](const StepSpec& step) {
    if (step.shape != "GIMP" && step.shape != "CPDI") return;
    for (const auto& make : {block, ball}) {
      const Scene scene = make(GetParam(), step, false);
      expect_same_alone(
          scene, [&](State& state) { advance_to(scene, 1.0, state, 8); }, rows_and_cavities
      );
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Modes, LoadOrders, ::testing::ValuesIn(all_modes));

}  // namespace
}  // namespace barreno
