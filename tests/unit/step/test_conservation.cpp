// SPDX-License-Identifier: BSD-3-Clause
// Balances of whole steps, on any number of ranks.
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

/// Two elastic plates (plane strain), blunt rods (axisymmetry) or boxes that meet.
Scene collision(Mode mode) {
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.040, 0.010}, testing::elastic(70e9, 0.3, 2700.0)
  );
  add_box(scene, "lower", {0.0, 0.006, 0.0}, {0.0083, 0.0179, 0.0042}, 2).velocity = {0, 120, 0};
  add_box(scene, "upper", {0.0, 0.020, 0.0}, {0.0061, 0.0307, 0.0053}, 3).velocity = {0, -80, 0};
  add_symmetry(scene, Face::x_lower);
  if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
  return scene;
}

class Conservation : public ::testing::TestWithParam<Mode> {};

TEST_P(Conservation, CollisionKeepsMassAndAxialMomentumAndItsEnergyLedgerCloses) {
  const Scene scene = collision(GetParam());
  State state = start(scene);
  advance_to(scene, 2.0e-5, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_GT(state.clock.step, 50);
  EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
  // The bodies did meet: they stored energy and lost some between particles and grid.
  EXPECT_GT(ledger.elastic, 0.01 * ledger.initial_kinetic);
  EXPECT_LT(ledger.transfer, 0.0);
}

TEST_P(Conservation, PicGivesAwayEnergyAndSaysSo) {
  Scene scene = collision(GetParam());
  scene.step.pic_fraction = 0.1;
  State state = start(scene);
  advance_to(scene, 2.0e-5, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
  EXPECT_LT(ledger.transfer, -0.02 * ledger.initial_kinetic);
}

INSTANTIATE_TEST_SUITE_P(Modes, Conservation, ::testing::ValuesIn(all_modes));

/// All digits of a term, over the ranks.
std::vector<long long> digits(const Comm& comm, const ReproducibleSum& term) {
  std::vector<ReproducibleSum> sums{term};
  sum_over_ranks(comm, sums);
  sums[0].carry();
  return {sums[0].part, sums[0].part + ReproducibleSum::parts};
}

/// A rod of copper hits a core that starts under pressure.
TEST(Conservation, EnergiesOfTheMaterialsAddUpToTheLedgerDigitForDigit) {
  Scene scene =
      box_scene(Mode::axisymmetric, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.040, 0.0}, testing::copper());
  scene.materials.push_back(testing::elastic(20e9, 0.25, 2300.0));
  add_box(scene, "rod", {0.0, 0.002, 0.0}, {0.0032, 0.0135, 0.0}, 2).velocity = {0.0, 300.0, 0.0};
  BodySpec& core = add_box(scene, "core", {0.0, 0.014, 0.0}, {0.0117, 0.034, 0.0}, 2);
  core.material = 1;
  core.initial_pressure = 70e6;
  State state = start(scene);
  advance_to(scene, 1.0e-5, state);
  const Comm& comm = *state.grid.comm;
  const OwnLedger& ledger = state.ledger;
  ASSERT_EQ(ledger.materials.size(), 2U);
  OwnMaterialEnergies sum;
  for (const OwnMaterialEnergies& one : ledger.materials) {
    sum.prestress += one.prestress;
    sum.elastic += one.elastic;
    sum.plastic += one.plastic;
    sum.viscous += one.viscous;
  }
  EXPECT_EQ(digits(comm, sum.prestress), digits(comm, ledger.prestress));
  EXPECT_EQ(digits(comm, sum.elastic), digits(comm, ledger.elastic));
  EXPECT_EQ(digits(comm, sum.plastic), digits(comm, ledger.plastic));
  EXPECT_EQ(digits(comm, sum.viscous), digits(comm, ledger.viscous));
  // Each has its own: the metal alone flows, the core alone started under pressure.
  const Ledger whole = sum_over_ranks(comm, ledger);
  ASSERT_EQ(whole.materials.size(), 2U);
  EXPECT_GT(whole.materials[0].plastic, 0.1 * whole.initial_kinetic);
  EXPECT_EQ(whole.materials[1].plastic, 0.0);
  EXPECT_EQ(whole.materials[0].prestress, 0.0);
  EXPECT_GT(whole.materials[1].prestress, 0.0);
  EXPECT_NE(whole.materials[0].elastic, 0.0);
  EXPECT_GT(whole.materials[1].elastic, 0.01 * whole.initial_kinetic);
  EXPECT_GT(whole.materials[0].viscous, 0.0);
}

TEST(Conservation, ImpulseOfAWallIsCounted) {
  Scene scene =
      box_scene(Mode::axisymmetric, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.040, 0.0}, testing::copper());
  add_box(scene, "rod", {0.0, 0.0, 0.0}, {0.0032, 0.0200, 0.0}, 2).velocity = {0.0, -200.0, 0.0};
  add_symmetry(scene, Face::y_lower);
  State state = start(scene);
  advance_to(scene, 1.0e-5, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_GT(ledger.condition_impulse, 0.1 * std::abs(ledger.initial_momentum));
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_GT(ledger.plastic, 0.1 * ledger.initial_kinetic);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 2e-3);
}

/// A body under pressure, stress and loads consistent, does not move: the discrete equilibrium is
/// exact.
TEST(Conservation, ConfinedBodyStaysAtRest) {
  for (const Mode mode : all_modes) {
    Scene scene = box_scene(
        mode, 1e-3, {0.0, 0.0, 0.0}, {0.020, 0.040, 0.012}, testing::elastic(20e9, 0.25, 2300.0)
    );
    add_box(scene, "core", {0.0, 0.0052, 0.0}, {0.0117, 0.0277, 0.0083}, 2).initial_pressure = 70e6;
    PressureLoadSpec load;
    load.faces[static_cast<std::size_t>(Face::x_upper)] = true;
    load.faces[static_cast<std::size_t>(Face::y_lower)] = true;
    load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
    load.faces[static_cast<std::size_t>(Face::z_upper)] = mode == Mode::three_dimensional;
    load.pressure = {{0.0}, {70e6}};
    scene.loads.push_back(load);
    add_symmetry(scene, Face::x_lower);
    if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
    State state = start(scene);
    advance_to(scene, 2e-5, state);
    // Speed of the free surface if the pressure were missing: p / (rho c).
    const double free_speed = 70e6 / (2300.0 * std::sqrt(24e9 / 2300.0));
    for (const auto& row : testing::all_rows(state))
      EXPECT_LT(std::hypot(row[2], row[3]), 1e-9 * free_speed);
  }
}

}  // namespace
}  // namespace barreno
