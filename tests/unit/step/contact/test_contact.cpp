// SPDX-License-Identifier: BSD-3-Clause
// Contact between velocity fields: its balances, and the same bits on any number of ranks.
#include "base/gather.hpp"
#include "state/balance.hpp"
#include "support/expect_same_alone.hpp"
#include "unit/step/contact/oblique_blocks.hpp"

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
using testing::box_scene;
using testing::expect_same_alone;
using testing::is_alone;
using testing::start;
using testing::start_alone;

/// In three dimensions in larger cells.
Scene oblique(Mode mode) {
  const bool space = mode == Mode::three_dimensional;
  return testing::oblique_blocks(mode, space ? 2e-3 : 1e-3, space ? 2 : 3);
}

TEST(ContactFields, MaterialsWithEqualContactsShareAField) {
  Scene scene = oblique(Mode::plane_strain);
  VelocityFields fields = velocity_fields(scene);
  EXPECT_EQ(fields.count, 3);
  ASSERT_EQ(fields.pairs.size(), 3U);
  EXPECT_EQ(fields.pairs[2].kind, ContactKind::bonded);
  scene.contacts[0] = {"faces", {1, 0}, ContactKind::frictionless, 0.0};
  fields = velocity_fields(scene);
  EXPECT_EQ(fields.count, 2);
  EXPECT_EQ(fields.of_material[1], fields.of_material[2]);
  scene.contacts.clear();
  EXPECT_EQ(velocity_fields(scene).count, 1);
}

class Contact : public ::testing::TestWithParam<Mode> {};

TEST_P(Contact, KeepsMassAndAxialMomentumAndItsEnergyLedgerCloses) {
  const Scene scene = oblique(GetParam());
  State state = start(scene);
  advance_to(scene, 2.0e-5, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
  EXPECT_GT(ledger.elastic, 0.01 * ledger.initial_kinetic);
  EXPECT_GT(ledger.friction, 1e-5 * ledger.initial_kinetic);
}

TEST_P(Contact, AnyRankCountGivesTheSameBits) {
  const Scene scene = oblique(GetParam());
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  expect_same_alone(scene, [&](State& state) {
    advance_to(scene, 1.2e-5, state);
    EXPECT_NE(sum_over_ranks(*state.grid.comm, state.ledger).friction, 0.0);
  });
}

/// Two bonded blocks of different materials that rebound from a third, in small cells: where all
/// three meet, a push that another pair has made needless would do work in every step.
TEST(ContactOfThreeFields, NodesOfThreeFieldsGainNoEnergy) {
  if (!is_alone()) return;  // any rank count gives the same bits
  testing::ObliqueBlocks blocks;
  for (Box* box : {&blocks.high, &blocks.beside}) {
    box->lower[1] = 0.0184;
    box->upper[1] = 0.0291;
  }
  Scene scene = testing::oblique_blocks(Mode::plane_strain, 0.25e-3, 2, blocks);
  for (ContactSpec& contact : scene.contacts) contact.kind = ContactKind::frictionless;
  State state = start(scene);
  advance_to(scene, 5e-6, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_GT(ledger.elastic, 0.5 * ledger.initial_kinetic) << "they did meet";
  EXPECT_LT(ledger.transfer, 0.0);
  EXPECT_GT(ledger.transfer, -0.01 * ledger.initial_kinetic);
}

INSTANTIATE_TEST_SUITE_P(Modes, Contact, ::testing::ValuesIn(all_modes));

/// Two blocks that meet along z: what friction takes from one it gives to the other, in the plane
/// of the faces, and no more than its coefficient times the push.
TEST(ContactInSpace, PushAndFrictionAreAsAlongTheOtherAxes) {
  Scene scene = box_scene(
      Mode::three_dimensional,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.012, 0.012, 0.016},
      testing::elastic(70e9, 0.3, 2700.0)
  );
  scene.materials.push_back(scene.materials[0]);
  constexpr double friction = 0.25, closing = 40.0;
  add_box(scene, "low", {0.003, 0.003, 0.003}, {0.008, 0.008, 0.007}, 2);
  BodySpec& high = add_box(scene, "high", {0.003, 0.003, 0.007}, {0.008, 0.008, 0.011}, 2);
  high.material = 1;
  high.velocity = {0.0, 90.0, -closing};
  scene.contacts.push_back({"faces", {0, 1}, ContactKind::friction, friction});
  State state = start(scene);
  advance_to(scene, 4e-6, state);
  double moved[2][3] = {};  // momentum of the materials [kg m/s]
  for (std::size_t m = 0; m < 2; ++m) {
    std::vector<double> sums(3, 0.0);
    const Particles& set = state.particles[m];
    for (int p = 0; p < set.count; ++p)
      for (int d = 0; d < 3; ++d)
        sums[static_cast<std::size_t>(d)] += set.mass(p) * set.velocity(p, d);
    sum_over_ranks(*state.grid.comm, sums);
    std::copy(sums.begin(), sums.end(), moved[m]);
  }
  const double mass = 2700.0 * 0.005 * 0.005 * 0.004;
  const double size = mass * closing;
  EXPECT_NEAR((moved[0][0] + moved[1][0]) / size, 0.0, 1e-12);
  EXPECT_NEAR((moved[0][1] + moved[1][1] - mass * 90.0) / size, 0.0, 1e-12);
  EXPECT_NEAR((moved[0][2] + moved[1][2] + size) / size, 0.0, 1e-12);
  EXPECT_LT(moved[0][2], -0.3 * size) << "they did meet";
  // All of the contact slides: 90 m/s is more than friction can stop.
  EXPECT_NEAR(moved[0][1] / -moved[0][2], friction, 0.02 * friction);
  EXPECT_NEAR(moved[0][0] / moved[0][2], 0.0, 1e-3);
}

/// A rigid punch of prescribed motion, with contact or without one.
Scene punch(bool contact) {
  Scene scene = box_scene(
      Mode::axisymmetric,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.016, 0.040, 0.0},
      testing::elastic(70e9, 0.3, 2700.0)
  );
  scene.materials.push_back(scene.materials[0]);
  add_box(scene, "block", {0.0, 0.006, 0.0}, {0.0103, 0.0179, 0.0}, 2);
  BodySpec& body = add_box(scene, "punch", {0.0, 0.0181, 0.0}, {0.0052, 0.0301, 0.0}, 2);
  body.material = 1;
  body.motion.prescribed = true;
  body.motion.velocity = {0.0, -40.0, 0.0};
  body.motion.factor = {{0.0, 1e-5}, {1.0, 0.5}};
  if (contact) scene.contacts.push_back({"face", {1, 0}, ContactKind::friction, 0.2});
  add_symmetry(scene, Face::x_lower);
  add_symmetry(scene, Face::y_lower);
  return scene;
}

TEST(RigidBody, MovesAsPrescribedAndItsImpulseAndWorkAreInTheBalances) {
  for (const bool contact : {false, true}) {
    SCOPED_TRACE(contact);
    const Scene scene = punch(contact);
    State state = start(scene), alone = start_alone(scene);
    advance_to(scene, 1.5e-5, state);
    advance_to(scene, 1.5e-5, alone);
    EXPECT_EQ(all_rows(alone), all_rows(state));
    const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
    EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
    EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
    EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-7);
    // Bonded to the punch the block swings to and fro; otherwise it can only be pushed.
    if (contact) {
      EXPECT_LT(ledger.rigid_impulse, 0.0);
      EXPECT_GT(ledger.friction, 0.0);
    }
    EXPECT_GT(ledger.boundary_work, 0.0);
    // 40 m/s falling to 20 m/s within 10 us, then 20 m/s; steps end inside the bend.
    const auto& rigid = alone.particles[1];
    for (int p = 0; p < rigid.count; ++p) {
      EXPECT_EQ(rigid.velocity(p, 1), -20.0);
      EXPECT_EQ(rigid.stress(p, 1), 0.0);
    }
    const Scene still = punch(contact);
    const State before = start_alone(still);
    double first = HUGE_VAL, now = HUGE_VAL;
    for (int p = 0; p < rigid.count; ++p) {
      first = std::min(first, before.particles[1].position(p, 1));
      now = std::min(now, rigid.position(p, 1));
    }
    EXPECT_NEAR(now - first, -(30.0 * 1e-5 + 20.0 * 0.5e-5), 1e-6);
  }
}

}  // namespace
}  // namespace barreno
