// SPDX-License-Identifier: BSD-3-Clause
// Whole steps in three dimensions: uniform strain, waves, turning, and plane strain as a slab.
#include "base/numbers.hpp"
#include "base/rows.hpp"
#include "shape/kinematics.hpp"
#include "state/balance.hpp"
#include "step/particles/update_deformation.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_rows;
using testing::box_scene;
using testing::start;

constexpr Mode space = Mode::three_dimensional;

/// Copper bar into a copper block, in the plane or in a slab one cell thick.
Scene impact(Mode mode) {
  constexpr double h = 1e-3;
  Scene scene = box_scene(mode, h, {0.0, 0.0, 0.0}, {0.016, 0.024, h}, testing::copper());
  add_box(scene, "bar", {0.0, 0.003, 0.0}, {0.0041, 0.0099, h}, 2).velocity = {100.0, 800.0, 0.0};
  add_box(scene, "block", {0.0, 0.0103, 0.0}, {0.0102, 0.0172, h}, 2);
  add_symmetry(scene, Face::x_lower);
  if (mode == space)
    for (const Face face : {Face::z_lower, Face::z_upper}) add_symmetry(scene, face);
  scene.step.largest_step = 2.5e-8;  // the modes' own differ: sqrt(3 / 2), and lone particles
  scene.step.initial_step = 2.5e-8;
  return scene;
}

TEST(ThreeDimensions, SlabOfOneCellIsPlaneStrain) {
  const Scene plane = impact(Mode::plane_strain), slab = impact(space);
  State in_plane = start(plane), in_space = start(slab);
  advance_to(plane, 4e-6, in_plane);
  advance_to(slab, 4e-6, in_space);
  ASSERT_EQ(in_plane.clock.step, in_space.clock.step);
  EXPECT_EQ(in_plane.clock.step, 160);
  auto flat = all_rows(in_plane), solid = all_rows(in_space);
  ASSERT_EQ(2 * flat.size(), solid.size());
  // Pairs of particles share x and y at the start, but not their ids: sort by what they share.
  const auto by_place = [](const auto& a, const auto& b) { return a[0] < b[0]; };
  std::sort(flat.begin(), flat.end(), by_place);
  std::sort(solid.begin(), solid.end(), by_place);
  const double size[9] = {0.01, 0.01, 800.0, 800.0, 1e10, 1e10, 1e10, 1e10, 1.0};
  for (std::size_t i = 0; i < solid.size(); ++i) {
    for (std::size_t c = 0; c < 9; ++c)
      ASSERT_NEAR(solid[i][c], flat[i / 2][c], 1e-10 * size[c]) << "column " << c;
    ASSERT_NEAR(solid[i][10], 0.0, 1e-9);  // vz
    ASSERT_NEAR(solid[i][11], 0.0, 1.0);   // syz, szx [Pa]
    ASSERT_NEAR(solid[i][12], 0.0, 1.0);
  }
  const Ledger a = sum_over_ranks(*in_plane.grid.comm, in_plane.ledger);
  const Ledger b = sum_over_ranks(*in_space.grid.comm, in_space.ledger);
  EXPECT_NEAR(b.plastic / (1e-3 * a.plastic), 1.0, 1e-10);
  EXPECT_NEAR(b.momentum / (1e-3 * a.momentum), 1.0, 1e-10);
}

/// A body whose edges and velocities follow a cyclic permutation of the axes.
Scene tumbling(std::size_t turn) {
  const auto turned = [turn](double a, double b, double c) {
    const double values[3] = {a, b, c};
    Vector v{};
    for (std::size_t d = 0; d < 3; ++d) v[(d + turn) % 3] = values[d];
    return v;
  };
  Scene scene =
      box_scene(space, 1e-3, {0.0, 0.0, 0.0}, turned(0.012, 0.016, 0.009), testing::copper());
  BodySpec& bar =
      add_box(scene, "bar", turned(0.002, 0.0, 0.0011), turned(0.0051, 0.0092, 0.0073), 2);
  bar.velocity = turned(150.0, -300.0, 80.0);
  bar.velocity_wave_number = turned(120.0, 170.0, -240.0);
  add_box(scene, "block", turned(0.006, 0.002, 0.002), turned(0.0091, 0.0082, 0.0073), 2).velocity =
      turned(-250.0, 0.0, 40.0);
  for (int side = 0; side < 2; ++side)
    add_symmetry(scene, static_cast<Face>(2 * ((1 + turn) % 3) + static_cast<std::size_t>(side)));
  return scene;
}

TEST(ThreeDimensions, AllAxesAreAlike) {
  std::vector<Ledger> ledgers;
  for (const std::size_t turn : {0U, 1U, 2U}) {
    const Scene scene = tumbling(turn);
    State state = start(scene);
    advance_to(scene, 4e-6, state);
    ledgers.push_back(sum_over_ranks(*state.grid.comm, state.ledger));
    EXPECT_NEAR(energy_balance(ledgers.back()).error(), 0.0, 2e-3);
    EXPECT_NEAR(mass_balance(ledgers.back()).error(), 0.0, 1e-14);
  }
  const Ledger& first = ledgers.front();
  EXPECT_GT(first.plastic, 0.02 * first.initial_kinetic);
  for (const Ledger& other : ledgers)
    for (const auto member :
         {&Ledger::kinetic, &Ledger::elastic, &Ledger::plastic, &Ledger::transfer})
      EXPECT_NEAR((other.*member) / (first.*member), 1.0, 1e-9);
}

/// v = v0 sin(k y), free of forces at its ends and held at its sides: after half a period the
/// velocities are reversed.
TEST(ThreeDimensions, StandingWaveHasItsPeriod) {
  constexpr double young = 100e9, poisson = 0.3, density = 4000.0, length = 0.048, h = 1e-3;
  const double modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double half_period = length / std::sqrt(modulus / density);
  Scene scene = box_scene(
      space, h, {0.0, 0.0, 0.0}, {2 * h, length, 2 * h}, testing::elastic(young, poisson, density)
  );
  BodySpec& bar = add_box(scene, "bar", {0.0, 0.0, 0.0}, {2 * h, length, 2 * h}, 2);
  bar.velocity = {0.0, 1e-3, 0.0};
  bar.velocity_wave_number = {0.0, pi / length, 0.0};
  for (int face = 0; face < 6; ++face) add_symmetry(scene, static_cast<Face>(face));
  scene.step.linear_viscosity = scene.step.quadratic_viscosity = 0.0;
  State state = start(scene);
  const auto before = all_rows(state);
  advance_to(scene, half_period, state);
  const auto after = all_rows(state);
  double worst = 0.0;
  for (std::size_t i = 0; i < after.size(); ++i)
    worst = std::max(worst, std::abs(after[i][3] + before[i][3]));
  EXPECT_LT(worst, 0.01 * 1e-3);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR((ledger.kinetic + ledger.elastic) / ledger.initial_kinetic, 1.0, 1e-3);
}

/// The only particle of a set, and the increment that it takes.
struct OneParticle {
  Scene scene;
  Particles particles;

  OneParticle()
      : scene(box_scene(space, 1.0, {}, {1.0, 1.0, 1.0}, testing::copper())),
        particles(make_particles(scene, 0)) {
    NewParticle made;
    made.x = made.half = {0.5, 0.5, 0.5};
    made.volume = 1.0;
    const MaterialSpec& material = scene.materials.front();
    add_particles(material, {made}, 0, start_point(material, nullptr), particles);
  }
  /// Advances F by I + a and gives the strain increment.
  Sym3 take(const SpaceTensor& a, Gradient gradient = Gradient::at_start) {
    store_tensor<ThreeDimensional>(a, particles.increment.values, 0);
    update_deformation(scene.grid.mode, Rows{0, 1}, gradient, particles);
    const Field& e = particles.increment;
    return {e(0, 0), e(0, 1), e(0, 2), e(0, 3), e(0, 4), e(0, 5)};
  }
};

SpaceTensor spin(double x, double y, double z) {
  return {0.0, -z, y, z, 0.0, -x, -y, x, 0.0};
}

/// Particles move straight, by dt v: a body that turns by Q has dt L = Q - I where it comes from,
/// I - Q^-1 where it goes to.
void turn_rigidly(Gradient gradient) {
  OneParticle one;
  const SpaceTensor turn = exponential(spin(0.003, -0.005, 0.002));
  const SpaceTensor step =
      gradient == Gradient::at_start ? plus(-1.0, turn) : plus(1.0, scaled(-1.0, transpose(turn)));
  for (int i = 0; i < 10000; ++i) {
    const Sym3 strain = one.take(step, gradient);
    ASSERT_LT(contract(strain, strain), 1e-31);
  }
  const SpaceTensor whole = exponential(spin(30.0, -50.0, 20.0));
  const auto& p = one.particles;
  const SpaceTensor r =
      matrix(load_rotation<ThreeDimensional>(p.deformation_gradient.values, p.rotation.values, 0));
  EXPECT_NEAR(r.xx, whole.xx, 1e-12);
  EXPECT_NEAR(r.xy, whole.xy, 1e-12);
  EXPECT_NEAR(r.zx, whole.zx, 1e-12);
  EXPECT_NEAR(r.yz, whole.yz, 1e-12);
  EXPECT_NEAR(p.volume(0), 1.0, 1e-13);
}
TEST(ThreeDimensions, RigidTurningStrainsNothing) {
  turn_rigidly(Gradient::at_start);
  turn_rigidly(Gradient::at_end);
}

/// While it turns by 3 rad, the particle is stretched by exp(D) along fixed axes of its own, so its
/// strain is D: dt L = Q1 (I + D / n) Q0^T - I in each of n equal steps. Error of their sum.
double strain_error(int n) {
  OneParticle one;
  const Sym3 d{0.3, -0.2, 0.1, 0.15, -0.1, 0.05};
  const SpaceTensor rate{d.xx, d.xy, d.zx, d.xy, d.yy, d.yz, d.zx, d.yz, d.zz};
  const SpaceTensor stretch = plus(1.0, scaled(1.0 / n, rate));
  const SpaceTensor turn = spin(1.2, -2.0, 1.8);
  Sym3 sum;
  for (int i = 0; i < n; ++i) {
    const SpaceTensor before = exponential(scaled(static_cast<double>(i) / n, turn));
    const SpaceTensor after = exponential(scaled((i + 1.0) / n, turn));
    const SpaceTensor f = multiply(after, multiply(stretch, transpose(before)));
    sum = sum + one.take(plus(-1.0, f));
  }
  const Sym3 error = sum - d;
  return std::sqrt(contract(error, error));
}

TEST(ThreeDimensions, StrainOfATurningParticleIsOfSecondOrder) {
  const double coarse = strain_error(40), fine = strain_error(80);
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(coarse / fine, 4.0, 0.2);
}

TEST(ThreeDimensions, RoundSlugsHaveTheMassOfTheTable) {
  for (const double lower : {0.0, -0.01}) {
    Scene scene =
        box_scene(space, 1e-3, {lower, 0.0, lower}, {0.01, 0.02, 0.01}, testing::copper());
    if (lower == 0.0)
      for (const Face face : {Face::x_lower, Face::z_lower}) add_symmetry(scene, face);
    scene.jet.present = true;
    scene.jet.launch_position = 0.01;
    scene.jet.particles_per_cell = 2;
    scene.jet.slugs = {{0.0, 3000.0, 0.00237, 0.004, 8930.0}};
    State state = start(scene);
    advance_to(scene, 1e-9, state, 1);
    const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
    const double exact = 8930.0 * pi * 0.00237 * 0.00237 * 0.004 * (lower == 0.0 ? 0.25 : 1.0);
    EXPECT_NEAR(ledger.launched_mass / exact, 1.0, 1e-9);
    EXPECT_NEAR(ledger.launched_momentum / (exact * 3000.0), 1.0, 1e-9);
    EXPECT_NEAR(jet_table_totals(scene, 1).mass / exact, 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace barreno
