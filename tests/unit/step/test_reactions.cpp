// SPDX-License-Identifier: BSD-3-Clause
// Forces on rigid bodies against exact answers, and the same on any number of ranks.
#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "output/reactions.hpp"
#include "state/balance.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::box_scene;
using testing::start;
using testing::start_alone;

constexpr double young = 20e9, density = 2300.0, h = 1e-3, width = 3.0 * h;
const double wave_speed = std::sqrt(young / density);

/// Of the bar: a circle, a strip of unit thickness, a square.
double area(Mode mode) {
  if (mode == Mode::axisymmetric) return pi * width * width;
  return mode == Mode::plane_strain ? width : width * width;
}
/// Place of the axial part among a body's reactions.
std::size_t axial(Mode mode) {
  return mode == Mode::axisymmetric ? 0 : 1;
}

/// A bar along y without Poisson's effect, whose waves travel along it alone, and a rigid plate at
/// one end of it. Planes of symmetry on two sides, free on the others.
Scene bar_and_plate(Mode mode, double bar_from, double length, bool plate_above) {
  const bool space = mode == Mode::three_dimensional;
  const double most = space ? 6.0 * h : 8.0 * h;
  Scene scene = box_scene(
      mode, h, {0.0, 0.0, 0.0}, {most, 40.0 * h, most}, testing::elastic(young, 0.0, density)
  );
  scene.materials.push_back(scene.materials[0]);
  add_box(scene, "bar", {0.0, bar_from, 0.0}, {width, bar_from + length, width}, 2);
  const double from = plate_above ? bar_from + length : bar_from - 3.0 * h;
  BodySpec& plate =
      add_box(scene, "plate", {0.0, from, 0.0}, {width + h, from + 3.0 * h, width + h}, 2);
  plate.material = 1;
  plate.motion.prescribed = true;
  scene.contacts.push_back({"face", {1, 0}, ContactKind::frictionless, 0.0});
  add_symmetry(scene, Face::x_lower);
  if (space) add_symmetry(scene, Face::z_lower);
  return scene;
}

class Reactions : public ::testing::TestWithParam<Mode> {};

/// F = rho c v A until the wave comes back from the free end.
TEST_P(Reactions, PistonFeelsTheImpedanceOfTheBar) {
  constexpr double speed = 0.5, length = 24.0 * h;
  Scene scene = bar_and_plate(GetParam(), 4.0 * h, length, false);
  scene.bodies[1].motion.velocity = {0.0, speed, 0.0};
  State state = start(scene);
  const double back =
      2.0 * length / wave_speed;  // of the first of it; its front is some cells wide
  const double exact = -density * wave_speed * speed * area(GetParam());
  advance_to(scene, 0.2 * back, state);
  const double early = reaction_impulses(state)[axial(GetParam())];
  const double early_time = state.clock.time;
  advance_to(scene, 0.7 * back, state);
  const double late = reaction_impulses(state)[axial(GetParam())];
  EXPECT_NEAR((late - early) / (exact * (state.clock.time - early_time)), 1.0, 2e-3);
  EXPECT_NEAR(late / (exact * state.clock.time), 1.0, 2e-2) << "the front's width included";
  // What the piston lost is in the bar.
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR(ledger.momentum / -late, 1.0, 1e-12);
  EXPECT_NEAR(ledger.rigid_impulse / -late, 1.0, 1e-12);
}

/// Mean axial stress of the middle half of the bar by its particles.
double mean_stress(const State& state, double length) {
  std::vector<double> sums(2, 0.0);
  const Particles& bar = state.particles[0];
  for (int p = 0; p < bar.count; ++p) {
    if (std::abs(bar.position(p, 1) - 0.5 * length) > 0.25 * length) continue;
    sums[0] += bar.volume(p) * bar.stress(p, 1);
    sums[1] += bar.volume(p);
  }
  sum_over_ranks(*state.grid.comm, sums);
  return sums[0] / sums[1];
}

/// Force on a plate that has slowly shortened a column on a floor, against the stress of the column
/// and what the floor feels. @return its error against the shortening, E ln(1 - travel / length)
double column_error(Mode mode, double length) {
  Scene scene = bar_and_plate(mode, 0.0, length, true);
  add_symmetry(scene, Face::y_lower);
  const double transit = length / wave_speed, travel = 0.25 * h;
  scene.bodies[1].motion.velocity = {0.0, -travel / (2.0 * transit), 0.0};
  scene.bodies[1].motion.factor = {{0.0, 2.0 * transit, 4.0 * transit}, {0.0, 1.0, 0.0}};
  scene.step.damping = 3.0 / transit;
  State state = start(scene);
  advance_to(scene, 12.0 * transit, state);
  const double before = reaction_impulses(state)[axial(mode)], time = state.clock.time;
  const Ledger then = sum_over_ranks(*state.grid.comm, state.ledger);
  advance_to(scene, 16.0 * transit, state);
  const double given = reaction_impulses(state)[axial(mode)] - before;
  const Ledger now = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR((now.condition_impulse - then.condition_impulse) / given, 1.0, 1e-6);
  const double pressure = given / (state.clock.time - time) / area(mode);
  // Particles whose shape functions are as wide as before meet in a shortened column.
  EXPECT_NEAR(pressure / -mean_stress(state, length), 1.0, 0.5 * travel / length);
  return pressure / (-young * std::log(1.0 - travel / length)) - 1.0;
}

/// The cell at the plate is strained too little, which is of the first order.
TEST_P(Reactions, PlateCarriesTheStressOfTheColumnTimesItsArea) {
  const bool space = GetParam() == Mode::three_dimensional;  // which takes longer
  const double coarse = column_error(GetParam(), 8.0 * h);
  EXPECT_LT(std::abs(coarse), 1.0 / 8.0);
  if (space) return;
  const double fine = column_error(GetParam(), 32.0 * h);
  EXPECT_LT(std::abs(fine), 0.3 * std::abs(coarse));
}

/// Momentum of the bar along the axes that have reactions.
std::vector<double> momentum_of_bar(const State& state) {
  const int first = state.grid.mode == Mode::axisymmetric ? 1 : 0;
  std::vector<double> sum;
  const Particles& bar = state.particles[0];
  for (int d = first; d < bar.velocity.components; ++d) {
    sum.push_back(0.0);
    for (int p = 0; p < bar.count; ++p) sum.back() += bar.mass(p) * bar.velocity(p, d);
  }
  sum_over_ranks(*state.grid.comm, sum);
  return sum;
}

TEST_P(Reactions, AreTheSameOnAnyRankCountAndWhatTheBarGot) {
  for (const double pic_fraction : {0.0, 0.3})
    for (const ContactKind kind : {ContactKind::frictionless, ContactKind::stick}) {
      Scene scene = bar_and_plate(GetParam(), 4.0 * h, 12.0 * h, true);
      scene.conditions.clear();
      scene.contacts[0].kind = kind;
      scene.step.pic_fraction = pic_fraction;
      const bool ring = GetParam() == Mode::axisymmetric;
      scene.bodies[1].motion.velocity = {ring ? 0.0 : 20.0, -80.0, 10.0};
      State together = start(scene), alone = start_alone(scene);
      advance_to(scene, 1.0, together, 40);
      advance_to(scene, 1.0, alone, 40);
      const std::vector<double> given = reaction_impulses(together);
      EXPECT_EQ(reaction_impulses(alone), given);
      EXPECT_GT(given[axial(GetParam())], 0.0);
      const std::vector<double> got = momentum_of_bar(together);
      ASSERT_EQ(got.size(), given.size());
      for (std::size_t d = 0; d < got.size(); ++d)
        EXPECT_NEAR(got[d], -given[d], 1e-12 * given[axial(GetParam())]);
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, Reactions, ::testing::ValuesIn(all_modes));

TEST(ReactionColumns, ForceIsTheImpulseSinceTheRowBefore) {
  Scene scene = bar_and_plate(Mode::plane_strain, 0.0, 12.0 * h, true);
  scene.bodies[1].name = "my plate";
  const std::vector<std::string> names{
      "my_plate_force_x", "my_plate_impulse_x", "my_plate_force_y", "my_plate_impulse_y"};
  EXPECT_EQ(reaction_columns(scene), names);
  EXPECT_EQ(reaction_values({6.0, 4.0}, {2.0, 5.0}, 0.5), (std::vector<double>{8, 6, -2, 4}));
  EXPECT_EQ(reaction_values({6.0}, {6.0}, 0.0), (std::vector<double>{0, 6}));
  scene.grid.mode = Mode::three_dimensional;
  EXPECT_EQ(reaction_columns(scene).size(), 6U);
  scene.grid.mode = Mode::axisymmetric;
  EXPECT_EQ(reaction_columns(scene).size(), 2U);
  scene.bodies[1].motion.prescribed = false;
  EXPECT_TRUE(reaction_columns(scene).empty());
}

}  // namespace
}  // namespace barreno
