// SPDX-License-Identifier: BSD-3-Clause
// With Return Losses metals keep all energy of a step: what stress integration and FLIP take
// becomes heat.
#include "base/gather.hpp"
#include "scene/tile_levels.hpp"
#include "state/balance.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <cmath>
#include <string>

namespace barreno {
namespace {

constexpr std::size_t internal_energy = 2;  // in JohnsonCook::history_table()

/// Two blocks of copper that meet at 1000 m/s, to some time after their first shocks.
Scene colliding_blocks(Mode mode, const char* shape) {
  const double depth = dimensions(mode) == 3 ? 0.004 : 0.0;
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.012, 0.024, 3.0 * depth}, testing::copper()
  );
  testing::add_box(scene, "lower", {0.0, 0.004, depth}, {0.005, 0.012, 2.0 * depth}, 2).velocity = {
      0.0, 500.0, 0.0};
  testing::add_box(scene, "upper", {0.0, 0.012, depth}, {0.004, 0.020, 2.0 * depth}, 2).velocity = {
      0.0, -500.0, 0.0};
  testing::add_symmetry(scene, Face::x_lower);
  scene.step.shape = shape;
  return scene;
}

/// Kinetic and internal energy of all ranks.
struct Energies {
  double kinetic = 0.0, internal = 0.0;
};
Energies energies_of(const State& state) {
  std::vector<double> sums(2, 0.0);
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) {
      const Vector v = vector_of(particles.velocity, p);
      const double m = particles.mass(p);
      sums[0] += 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      sums[1] += m * particles.history(p, internal_energy);
    }
  sum_over_ranks(*state.grid.comm, sums);
  return {sums[0], sums[1]};
}

/// A metal whose waves are a quarter as fast as those of copper.
MaterialSpec slow_metal() {
  JohnsonCook::Parameters p;
  p.shear_modulus = 3e9;
  p.a = 20e6;
  p.m = 1.0;
  p.melt_temperature = 1356.0;
  p.specific_heat = 383.0;
  p.sound_speed = 1200.0;
  p.slope = 1.489;
  p.gamma = 2.02;
  return Material{"slow metal", 8930.0, JohnsonCook(p, 8930.0)};
}

/// Copper that hits it at 900 m/s: tiles without copper bear steps that are four times as long.
Scene slow_and_fast(Mode mode) {
  const double depth = dimensions(mode) == 3 ? 0.004 : 0.0;
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.048, 3.0 * depth}, testing::copper()
  );
  scene.materials.push_back(slow_metal());
  testing::add_box(scene, "copper", {0.0, 0.024, depth}, {0.004, 0.032, 2.0 * depth}, 2)
      .velocity = {0.0, -800.0, 0.0};
  BodySpec& slow =
      testing::add_box(scene, "slow", {0.0, 0.004, depth}, {0.006, 0.024, 2.0 * depth}, 2);
  slow.velocity = {0.0, 100.0, 0.0};
  slow.material = 1;
  testing::add_symmetry(scene, Face::x_lower);
  return scene;
}

/// Cells half as large where the two meet.
Scene refined(Scene scene) {
  const RefinedRegion region{Box{{0.0, 0.017, 0.0}, {0.006, 0.031, 0.008}}, 1};
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {region});
  return scene;
}

/// What is missing of the energy at the start, as part of it.
double missing(const Scene& scene, Ledger& ledger, double time = 3e-6) {
  State state = testing::start(scene);
  const Energies start = energies_of(state);
  testing::advance_to(scene, time, state);
  const Energies end = energies_of(state);
  EXPECT_GT(end.internal, 0.1 * start.kinetic);
  ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  return (start.kinetic - end.kinetic - end.internal) / start.kinetic;
}

TEST(ReturnedLosses, KeepAllEnergyInMetals) {
  for (const Mode mode : testing::all_modes)
    for (const char* shape : {"GIMP", "CPDI", "quadratic B-spline"}) {
      SCOPED_TRACE(std::string(word_of(mode)) + ", " + shape);
      Scene scene = colliding_blocks(mode, shape);
      Ledger lost, returned;
      EXPECT_GT(std::abs(missing(scene, lost)), 1e-3);
      scene.step.return_losses = true;
      EXPECT_LT(std::abs(missing(scene, returned)), 1e-12);
      EXPECT_LT(std::abs(energy_balance(returned).error()), 1e-12);
      EXPECT_LT(returned.transfer, 0.0);
      EXPECT_NEAR(returned.stress_integration / -returned.transfer, 1.0, 1e-9);
    }
}

/// A tile that ends a step of several parts returns what its particles lost in all of them, to its
/// neighbours' nodes too: parts have one length, and forces stay as they are within the step.
TEST(ReturnedLosses, KeepAllEnergyWhereTilesTakeStepsOfTheirOwn) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain}) {
    SCOPED_TRACE(word_of(mode));
    Scene scene = slow_and_fast(mode);
    scene.step.subcycles = 4;
    Ledger lost, returned;
    EXPECT_GT(missing(scene, lost, 8e-6), 5e-3);
    scene.step.return_losses = true;
    EXPECT_LT(std::abs(missing(scene, returned, 8e-6)), 1e-11);
    EXPECT_LT(std::abs(energy_balance(returned).error()), 1e-11);
    EXPECT_LT(returned.transfer, 0.0);
  }
}

/// Nodes at the border of two levels that are no unknowns move by the mean of their neighbours, and
/// what that costs of the increments' energy belongs to no particle: a small part of the losses.
TEST(ReturnedLosses, KeepNearlyAllEnergyOnLevels) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain})
    for (const int subcycles : {1, 4}) {
      SCOPED_TRACE(std::string(word_of(mode)) + ", " + std::to_string(subcycles));
      Scene scene = refined(slow_and_fast(mode));
      scene.step.subcycles = subcycles;
      Ledger lost, returned;
      const double without = missing(scene, lost, 6e-6);
      scene.step.return_losses = true;
      const double with = missing(scene, returned, 6e-6);
      EXPECT_GT(without, 5e-3);
      EXPECT_GT(with, -1e-11);
      EXPECT_LT(with, 0.05 * without);
      EXPECT_LT(std::abs(energy_balance(returned).error()), 1e-11);
    }
}

/// What knows no heat has no field for it and does what it did.
TEST(ReturnedLosses, AreNothingToOtherMaterials) {
  Scene scene = testing::box_scene(
      Mode::plane_strain,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.008, 0.008, 0.0},
      testing::elastic(1e9, 0.2, 1000.0)
  );
  testing::add_box(scene, "block", {0.002, 0.002, 0.0}, {0.006, 0.006, 0.0}, 2).velocity = {
      3.0, 2.0, 0.0};
  State before = testing::start(scene);
  scene.step.return_losses = true;
  State after = testing::start(scene);
  EXPECT_EQ(after.particles.front().heat.components, 0);
  testing::advance_to(scene, 1e-5, before);
  testing::advance_to(scene, 1e-5, after);
  EXPECT_EQ(testing::all_rows(before), testing::all_rows(after));
}

}  // namespace
}  // namespace barreno
