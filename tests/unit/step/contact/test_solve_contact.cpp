// SPDX-License-Identifier: BSD-3-Clause
// What two fields do to each other at one node: common velocities, friction, gaps, rigid bodies.
#include "step/contact/solve_contact.hpp"
#include "unit/step/contact/two_blocks.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace barreno {
namespace {

using testing::sums_at;

const std::vector<int> node{4, 4};

/// Masses 1 and 3 meet at a node with velocities (4, 2) and (-4, 2 + slide), under forces across
/// the surface between them, whose normal is along x.
struct Meeting {
  Scene scene;
  State state;

  Meeting(
      ContactKind kind, double friction, double slide, double gap, double push = 0.0, double h = 0.5
  )
      : scene(testing::two_blocks(Mode::plane_strain, h, 0.0, kind, friction)),
        state(testing::in_tiles(scene, 0.25)) {
    put(0, {1.0, 4.0, 2.0, push, 0.0});
    put(1, {3.0, -12.0, 3.0 * (2.0 + slide), -push, 0.0});
    detect();
    set_normal(0, gap);
  }
  /// Any bodies, of which nothing is at the node yet.
  explicit Meeting(Scene of_bodies)
      : scene(std::move(of_bodies)), state(testing::in_tiles(scene, 0.25)) {}

  void detect() {
    detect_contact_nodes(state.grid, state.fields, state.particles, state.nodes, state.contact);
  }
  void set_normal(std::size_t pair, double gap) {
    double* const n = testing::normal_at(state, 0, node, pair);
    n[0] = 1.0;
    n[1] = 0.0;
    n[2] = gap;
  }
  void put(int field, const std::vector<double>& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums_at(state, field, 0, node)[i] = sums[i];
  }
  RigidTally solve(double pic_fraction = 0.0) {
    StepSpec step;
    step.pic_fraction = pic_fraction;
    return solve_contact(
        state.grid,
        state.fields,
        state.rigid_motions,
        {0.0, 0.0, GridShare(step), NodeScaleRule(scene.materials, scene.grid)},
        state.contact,
        state.nodes
    );
  }
  /// Change of v^n, impulse over the step, its part along the surface; x and y of each.
  const double* impulse(int field) const {
    constexpr int components = impulse_components(2);
    return &state.nodes[static_cast<std::size_t>(field)].impulse(0) +
           testing::slot_of(state.grid, 0, node) * components;
  }
};

TEST(SolveContact, StickingSurfacesThatCloseGetTheirCommonVelocity) {
  Meeting m(ContactKind::stick, 0.0, 4.0, 0.0);
  m.solve();
  // (1 4 - 3 4) / 4 = -2 across, (1 2 + 3 6) / 4 = 5 along.
  EXPECT_DOUBLE_EQ(4.0 + m.impulse(0)[0], -2.0);
  EXPECT_DOUBLE_EQ(-4.0 + m.impulse(1)[0], -2.0);
  EXPECT_DOUBLE_EQ(2.0 + m.impulse(0)[1], 5.0);
  EXPECT_DOUBLE_EQ(6.0 + m.impulse(1)[1], 5.0);
  // Without forces the step itself needs no impulse.
  for (int i = 2; i < 6; ++i) EXPECT_NEAR(m.impulse(0)[i], 0.0, 1e-15);
}

TEST(SolveContact, FrictionlessSurfacesSlide) {
  Meeting m(ContactKind::frictionless, 0.0, 4.0, 0.0);
  m.solve();
  EXPECT_DOUBLE_EQ(4.0 + m.impulse(0)[0], -2.0);
  EXPECT_EQ(m.impulse(0)[1], 0.0);
  EXPECT_EQ(m.impulse(1)[1], 0.0);
}

TEST(SolveContact, FrictionIsAtMostItsCoefficientTimesThePressure) {
  // The normal impulse on the first is -6; sticking along y takes 3, Coulomb's limit is 1.5.
  Meeting slides(ContactKind::friction, 0.25, 4.0, 0.0);
  slides.solve();
  EXPECT_DOUBLE_EQ(slides.impulse(0)[1], 1.5);
  EXPECT_DOUBLE_EQ(slides.impulse(1)[1], -0.5);
  Meeting sticks(ContactKind::friction, 0.75, 4.0, 0.0);
  sticks.solve();
  EXPECT_DOUBLE_EQ(sticks.impulse(0)[1], 3.0);
}

/// No plane separates them: they get their common velocity, along every direction.
TEST(SolveContact, WhatIsEmbeddedInTheOtherMovesWithIt) {
  Meeting m(ContactKind::frictionless, 0.0, 4.0, -1.01);
  m.solve();
  EXPECT_DOUBLE_EQ(4.0 + m.impulse(0)[0], -2.0);
  EXPECT_DOUBLE_EQ(2.0 + m.impulse(0)[1], 5.0);
  EXPECT_DOUBLE_EQ(6.0 + m.impulse(1)[1], 5.0);
  Meeting overlaps(ContactKind::frictionless, 0.0, 4.0, -0.99);
  overlaps.solve();
  EXPECT_EQ(overlaps.impulse(0)[1], 0.0);
}

/// The first is pushed by the second until the third, bonded to that, has drawn it away: then no
/// push may be left.
TEST(SolveContact, APairTakesBackWhatAnotherPairMakesNeedless) {
  Scene scene = testing::two_blocks(Mode::plane_strain, 0.5, 0.0, ContactKind::frictionless);
  scene.materials.push_back(scene.materials[0]);
  testing::add_box(scene, "third", {3.0, 2.0, 0.0}, {3.5, 3.0, 0.0}, 2).material = 2;
  scene.contacts.push_back({"other", {0, 2}, ContactKind::stick, 0.0});
  Meeting m(std::move(scene));
  ASSERT_EQ(m.state.fields.count, 3);
  m.put(0, {1.0, 1.0, 0.0});
  m.put(1, {1.0, 0.0, 0.0});
  m.put(2, {1.0, 10.0, 0.0});
  m.detect();
  for (std::size_t pair = 0; pair < m.state.fields.pairs.size(); ++pair) m.set_normal(pair, 0.0);
  m.solve();
  EXPECT_NEAR(1.0 + m.impulse(0)[0], 1.0, 1e-12);
  EXPECT_NEAR(0.0 + m.impulse(1)[0], 5.0, 1e-12);
  EXPECT_NEAR(10.0 + m.impulse(2)[0], 5.0, 1e-12);
}

TEST(SolveContact, SurfacesThatSeparateAreFree) {
  Meeting m(ContactKind::friction, 0.5, 4.0, 0.0);
  m.put(0, {1.0, -4.0, 2.0});
  m.put(1, {3.0, 12.0, 6.0});
  m.solve();
  for (int i = 0; i < 6; ++i) EXPECT_EQ(m.impulse(0)[i], 0.0);
}

TEST(SolveContact, ForcesThatPressFieldsTogetherAreTakenByTheImpulseOfTheStep) {
  Meeting m(ContactKind::frictionless, 0.0, 0.0, 0.0, 16.0);
  m.put(0, {1.0, 0.0, 0.0});
  m.put(1, {3.0, 0.0, 0.0});
  m.solve();
  EXPECT_EQ(m.impulse(0)[0], 0.0);  // at rest before the step
  EXPECT_DOUBLE_EQ(m.impulse(0)[2], -16.0 * 0.25);
  EXPECT_DOUBLE_EQ(m.impulse(1)[2], 16.0 * 0.25);
}

TEST(SolveContact, SurfacesMayCloseTheirGapInTheStepOfTheirTile) {
  // Half a cell of 0.5 in 0.25: 1 of the 8 with which they close is free; in 0.125: 2.
  Meeting slow(ContactKind::frictionless, 0.0, 0.0, 0.5);
  slow.solve();
  EXPECT_DOUBLE_EQ(slow.impulse(0)[0], -0.75 * 7.0);
  Meeting fast(ContactKind::frictionless, 0.0, 0.0, 0.5);
  testing::set_tile_step(fast.state.grid, 0, 0.125);
  fast.solve();
  EXPECT_DOUBLE_EQ(fast.impulse(0)[0], -0.75 * 6.0);
  Meeting large(ContactKind::frictionless, 0.0, 0.0, 0.5);
  large.state.grid.tile_frame(0).cell_size = 1.0;
  large.solve();
  EXPECT_DOUBLE_EQ(large.impulse(0)[0], -0.75 * 6.0);
}

/// Two tiles, whose fields meet at a node of each: each as if all tiles took its step.
TEST(SolveContact, EveryTileTakesItsOwnStep) {
  const auto change = [](double low, double high, int tile) {
    Scene scene = testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::frictionless);
    scene.grid.upper[1] = 16.0;
    scene.bodies[0].shape = Box{{2.0, 2.0, 0.0}, {4.0, 14.0, 0.0}};
    scene.bodies[1].shape = Box{{4.0, 2.0, 0.0}, {6.0, 14.0, 0.0}};
    State state = testing::in_tiles(scene, low);
    testing::set_tile_step(state.grid, 1, high);
    for (int t = 0; t < 2; ++t) {
      double* const a = sums_at(state, 0, t, {4, 4 + 8 * t});
      double* const b = sums_at(state, 1, t, {4, 4 + 8 * t});
      a[0] = 1.0;
      a[1] = 4.0;
      a[first_force(2)] = 3.0;
      b[0] = 3.0;
      b[1] = -12.0;
    }
    detect_contact_nodes(state.grid, state.fields, state.particles, state.nodes, state.contact);
    for (int t = 0; t < 2; ++t) {
      double* const n = testing::normal_at(state, t, {4, 4 + 8 * t});
      n[0] = 1.0;
      n[1] = 0.0;
      n[2] = 0.25;
    }
    solve_contact(
        state.grid,
        state.fields,
        state.rigid_motions,
        {0.0, 0.0, GridShare(scene.step), NodeScaleRule(scene.materials, scene.grid)},
        state.contact,
        state.nodes
    );
    constexpr int components = impulse_components(2);
    const double* const out =
        &state.nodes[0].impulse(first_value(state.grid.patch, tile, components)) +
        testing::slot_of(state.grid, tile, {4, 4 + 8 * tile}) * components;
    return std::vector<double>(out, out + components);
  };
  EXPECT_EQ(change(0.25, 0.125, 0), change(0.25, 0.25, 0));
  EXPECT_EQ(change(0.25, 0.125, 1), change(0.125, 0.125, 1));
  EXPECT_NE(change(0.25, 0.25, 1), change(0.125, 0.125, 1));
}

TEST(SolveContact, ARigidBodyGivesWhatItTakesAndItsWorkIsCounted) {
  Meeting m(ContactKind::frictionless, 0.0, 0.0, 0.0);
  m.scene.bodies[1].motion.prescribed = true;
  m.scene.bodies[1].motion.velocity = {-4.0, 0.0, 0.0};
  m.scene.bodies[1].motion.factor = {{0.0, 1.0}, {0.0, 8.0}};  // 1 at the middle of the step
  State state = testing::in_tiles(m.scene, 0.25);
  ASSERT_EQ(state.rigid_motions.count, 1);
  ASSERT_EQ(state.rigid_motions.of_field[1], 0);
  m.state = state;
  m.put(0, {1.0, 0.0, 0.0, 16.0, 0.0});
  m.put(1, {3.0, 5.0, 0.0, 0.0, 0.0});  // its own momentum does not matter
  detect_contact_nodes(
      m.state.grid, m.state.fields, m.state.particles, m.state.nodes, m.state.contact
  );
  double* const n = testing::normal_at(m.state, 0, node);
  n[0] = 1.0;
  n[1] = n[2] = 0.0;
  const RigidTally tally = m.solve(0.5);
  // v^n becomes that of the body, -4; the force would bring the mass to 0 in the step.
  EXPECT_DOUBLE_EQ(m.impulse(0)[0], -4.0);
  EXPECT_DOUBLE_EQ(m.impulse(0)[2], -4.0);
  EXPECT_EQ(m.impulse(1)[0], 0.0);
  EXPECT_DOUBLE_EQ(tally.work.value(), -4.0 * -4.0);
  EXPECT_EQ(tally.tangential_work.value(), 0.0);
  // What particles take by PIC of the first impulse is a reaction too.
  EXPECT_DOUBLE_EQ(tally.reaction[0][0].value(), 4.0 + 0.5 * 4.0);
  EXPECT_EQ(tally.reaction[0][1].value(), 0.0);
}

}  // namespace
}  // namespace barreno
