// SPDX-License-Identifier: BSD-3-Clause
// Body forces, damping and symmetry planes: exact answers of single steps, and their places in the
// ledger.
#include "scene/body_force.hpp"
#include "state/balance.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::box_scene;
using testing::start;

Scene falling(Mode mode) {
  Scene scene = box_scene(
      mode, 1e-2, {0.0, 0.0, 0.0}, {0.16, 0.40, 0.08}, testing::elastic(70e6, 0.3, 2700.0)
  );
  add_box(scene, "stone", {0.0, 0.20, 0.02}, {0.05, 0.25, 0.06}, 2).velocity = {0.0, -1.0, 0.0};
  add_symmetry(scene, Face::x_lower);
  scene.body_force.kind = BodyForceKind::gravity;
  scene.body_force.acceleration = {0.0, -100.0, 0.0};
  scene.step.linear_viscosity = 0.0;
  scene.step.quadratic_viscosity = 0.0;
  return scene;
}

class AppliedForces : public ::testing::TestWithParam<Mode> {};

TEST_P(AppliedForces, AStoneFallsAsItShouldAndItsWorkIsCounted) {
  const Scene scene = falling(GetParam());
  State state = start(scene);
  advance_to(scene, 0.01, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  for (const auto& row : testing::all_rows(state)) EXPECT_NEAR(row[3], -2.0, 1e-10);
  EXPECT_NEAR(ledger.body_impulse, -1.0 * ledger.mass, 1e-12 * ledger.mass);
  EXPECT_NEAR(ledger.body_work, 0.5 * ledger.mass * (4.0 - 1.0), 1e-9 * ledger.mass);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-12);
}

TEST_P(AppliedForces, DampingSlowsExponentiallyAndIsCounted) {
  Scene scene = falling(GetParam());
  scene.body_force = {};
  scene.step.damping = 100.0;
  State state = start(scene);
  advance_to(scene, 0.01, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  // (1 - damping dt)^n against the exponential: the steps are some 1e-4 s.
  for (const auto& row : testing::all_rows(state)) EXPECT_NEAR(row[3], -std::exp(-1.0), 5e-3);
  EXPECT_NEAR(ledger.damped, ledger.initial_kinetic - ledger.kinetic, 1e-9 * ledger.damped);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Modes, AppliedForces, ::testing::ValuesIn(all_modes));

TEST(BodyForceInSpace, PullsAlongItsDirection) {
  Scene scene = falling(Mode::three_dimensional);
  scene.body_force.acceleration = {60.0, -100.0, 80.0};
  scene.conditions.clear();
  State state = start(scene);
  advance_to(scene, 0.005, state);
  for (const auto& row : testing::all_rows(state)) {
    EXPECT_NEAR(row[2], 0.3, 1e-10);
    EXPECT_NEAR(row[3], -1.5, 1e-10);
    EXPECT_NEAR(row[10], 0.4, 1e-10);
  }
}

/// Two equal bodies that meet at y = 0.2, or one of them before a symmetry plane there.
Scene impact(bool mirrored) {
  Scene scene = box_scene(
      Mode::plane_strain,
      1e-2,
      {0.0, 0.0, 0.0},
      {0.16, mirrored ? 0.20 : 0.40, 0.0},
      testing::elastic(70e6, 0.3, 2700.0)
  );
  // Off the cells, wider than a tile, and so close that pressed particles reach beyond the plane.
  add_box(scene, "lower", {0.012, 0.11, 0.0}, {0.123, 0.1999, 0.0}, 2).velocity = {3.0, 20.0, 0.0};
  if (!mirrored)
    add_box(scene, "upper", {0.012, 0.2001, 0.0}, {0.123, 0.29, 0.0}, 2).velocity = {
        3.0, -20.0, 0.0};
  else
    add_symmetry(scene, Face::y_upper);
  return scene;
}

TEST(SymmetryPlane, IsAMirror) {
  const Scene whole = impact(false);
  const Scene half = impact(true);
  State both = start(whole);
  State one = start(half);
  advance_to(whole, 4e-4, both);
  advance_to(half, 4e-4, one);
  const auto all = testing::all_rows(both);
  const auto lower = testing::all_rows(one);
  ASSERT_EQ(all.size(), 2 * lower.size());
  double peak = 0.0;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(lower[i][c], all[i][c], 1e-12);
    for (std::size_t c = 2; c < 4; ++c) EXPECT_NEAR(lower[i][c], all[i][c], 1e-9 * 20.0);
    peak = std::fmax(peak, std::fabs(lower[i][5]));
  }
  EXPECT_GT(peak, 1e5) << "they did meet";
  const Ledger ledger = sum_over_ranks(*one.grid.comm, one.ledger);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_LT(ledger.condition_impulse, -0.1 * ledger.initial_momentum);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
}

TEST(SymmetryPlane, CountsItsImpulseWithPicToo) {
  Scene half = impact(true);
  half.step.pic_fraction = 0.1;
  State one = start(half);
  advance_to(half, 4e-4, one);
  const Ledger ledger = sum_over_ranks(*one.grid.comm, one.ledger);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
}

/// Values of another program for the material E, nu, rho and a place and time; the code's own
/// phases are multiples of pi, and so are these points'.
TEST(BodyForce, AgreesWithAnotherProgram) {
  const auto spec = [](BodyForceKind kind, double young, double nu, double rho, double amplitude) {
    BodyForceSpec s;
    s.kind = kind;
    s.young = young;
    s.density = rho;
    s.shear = young / (2.0 * (1.0 + nu));
    s.lambda = young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    s.amplitude = amplitude;
    return s;
  };
  const Vector vortex =
      body_force(spec(BodyForceKind::vortex, 1000.0, 0.3, 1000.0, 1.0), {0.9, 0.3, 0.0}, 0.3);
  EXPECT_NEAR(vortex[0], -5.960476052602771, 1e-11);
  EXPECT_NEAR(vortex[1], 2.897372543949105, 1e-11);
  BodyForceSpec ring = spec(BodyForceKind::ring, 1e7, 0.0, 1000.0, 0.1);
  ring.inner_radius = 0.4;
  ring.outer_radius = 0.6;
  const Vector widening = body_force(ring, {0.45, 0.1, 0.0}, 0.004);
  EXPECT_NEAR(widening[0], -2786.6086878545307, 1e-8);
  EXPECT_NEAR(widening[1], -619.2463750787846, 1e-8);
}

}  // namespace
}  // namespace barreno
