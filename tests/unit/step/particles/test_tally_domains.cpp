// SPDX-License-Identifier: BSD-3-Clause
#include "shape/cpdi.hpp"
#include "step/particles/tally_domains.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <cmath>

namespace barreno {
namespace {

/// Two particles whose domains follow them.
Scene with_domains(double largest) {
  Scene scene = testing::two_tiles(Material{"elastic", 1.0, LinearElastic({2.0, 1.0}, 1.0)});
  scene.step.shape = Cpdi::word;
  scene.step.largest_domain = largest;
  scene.step.linear_viscosity = scene.step.quadratic_viscosity = 0.0;
  return scene;
}

DomainTally tally(
    const Scene& scene, State& state, BadParticlePolicy policy, bool own_field = false
) {
  return tally_domains(scene.step, policy, own_field, state.grid, state.particles[0]);
}

TEST(TallyDomains, OthersThanThoseThatDeformHaveNone) {
  Scene scene = with_domains(1.0);
  scene.step.shape = "GIMP";
  State state = testing::start_in_tiles(scene);
  const DomainTally found = tally(scene, state, BadParticlePolicy::stop);
  EXPECT_EQ(found.clipped, 0.0);
  EXPECT_TRUE(std::isinf(found.stable_step));
}

/// A corner of a square of half edges 1/2, drawn out to twice its length, is sqrt(1 + 1/4) cells
/// from the centre; in cells half as large it is twice as far.
TEST(TallyDomains, LongDomainsAreClippedInCellsOfTheirTile) {
  const Scene scene = with_domains(1.5);
  State state = testing::start_in_tiles(scene);
  Particles& particles = state.particles[0];
  testing::set_frame(state.grid, 0, 1.0, 0.1);
  testing::set_frame(state.grid, 1, 0.5, 0.1);
  for (int p = 0; p < 2; ++p) particles.deformation_gradient(p, 0) = 2.0;
  const DomainTally found = tally(scene, state, BadParticlePolicy::stop);
  EXPECT_EQ(found.clipped, 1.0);
  EXPECT_EQ(particles.clipped(testing::row_in(particles, 0)), 0.0);
  EXPECT_EQ(particles.clipped(testing::row_in(particles, 1)), 1.0);
  EXPECT_EQ(found.inverted, 0.0);
}

TEST(TallyDomains, AnInvertedDomainIsTreatedAsItsMaterialAsks) {
  const Scene scene = with_domains(1.0);
  for (const BadParticlePolicy policy : {BadParticlePolicy::remove, BadParticlePolicy::hold}) {
    State state = testing::start_in_tiles(scene);
    Particles& particles = state.particles[0];
    for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.1);
    const int p = testing::row_in(particles, 1);
    particles.deformation_gradient(p, 0) = -1.0;
    const DomainTally found = tally(scene, state, policy);
    EXPECT_EQ(found.inverted, 1.0);
    EXPECT_EQ(found.first_bad, particles.id(p));
    const bool held = policy == BadParticlePolicy::hold;
    EXPECT_EQ(particles.fault(p), held ? Fault::none : Fault::inverted);
    EXPECT_EQ((particles.body(p) & debris_bit) != 0, held);
    EXPECT_EQ(tally(scene, state, policy).inverted, 0.0);  // it is counted once
  }
}

/// A domain narrowed to a half has a critical Courant number of its own; its step is that share of
/// the set's, and goes with the cell size.
TEST(TallyDomains, ANarrowDomainLimitsTheStep) {
  const Scene scene = with_domains(1.0);
  State state = testing::start_in_tiles(scene);
  Particles& particles = state.particles[0];
  testing::set_frame(state.grid, 0, 1.0, 0.1);
  testing::set_frame(state.grid, 1, 4.0, 0.1);
  const int p = testing::row_in(particles, 0);
  particles.deformation_gradient(p, 0) = 0.5;
  particles.half_size(testing::row_in(particles, 1), 0) = 2.0;
  particles.half_size(testing::row_in(particles, 1), 1) = 2.0;
  const double narrow = Cpdi::critical_courant(0.25);
  ASSERT_LT(narrow, particles.critical_courant);
  particles.longitudinal_modulus(p) = 4.0;  // c = 2
  const double stable = scene.step.courant_fraction * narrow / std::sqrt(2.0) / 2.0;
  EXPECT_NEAR(tally(scene, state, BadParticlePolicy::stop).stable_step, stable, 1e-12);
}

/// A needle a tenth of a cell half wide, one end on a node, with c = 2 and density 1.
Scene with_needle(State& state, double viscous_pressure) {
  Scene scene = with_domains(1.0);
  scene.step.linear_viscosity = 0.3;
  state = testing::start_in_tiles(scene);
  for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.1);
  Particles& particles = state.particles[0];
  const int p = testing::row_in(particles, 0);
  particles.deformation_gradient(p, 0) = 0.2;
  particles.position(p, 0) = 3.1;
  particles.longitudinal_modulus(p) = 4.0;
  particles.viscous_pressure(p) = viscous_pressure;
  return scene;
}

/// Largest amplitude over many steps dt of a lone particle that is compressed and expanded with
/// its viscosity a step behind: strain s, rate r, and r <- r - dt k (nu r + c^2 s) with h = 1.
double amplitude_after_steps(double dt, double stiffness, double viscosity) {
  double strain = 1.0, rate = 0.0;
  for (int i = 0; i < 400; ++i) {
    rate -= dt * stiffness * (viscosity * rate + 4.0 * strain);
    strain += dt * rate;
  }
  return std::hypot(strain, dt * rate);
}

TEST(TallyDomains, ACompressedNeedleInAFieldOfItsOwnTakesStepsThatItsViscosityBears) {
  State state;
  const Scene scene = with_needle(state, 1.0);
  const double found = tally(scene, state, BadParticlePolicy::stop, true).stable_step;
  const double largest = found / scene.step.courant_fraction;
  const double stiffness = 1.0 / (0.1 * 0.9) + 4.0;  // of both axes
  const double viscosity = 0.3 * 2.0;                // Q of the linear term
  EXPECT_LT(amplitude_after_steps(0.99 * largest, stiffness, viscosity), 1.0);
  EXPECT_GT(amplitude_after_steps(1.01 * largest, stiffness, viscosity), 1e3);
}

TEST(TallyDomains, TheQuadraticViscosityOfANeedleCountsAsMuchAsItPresses) {
  State state;
  Scene scene = with_needle(state, 3.0);
  scene.step.quadratic_viscosity = 2.0;
  // q = rho (A1 c r + A2 r^2) = 3 of the rate r.
  const double rate = (-0.6 + std::sqrt(0.36 + 24.0)) / 4.0;
  const double speed = 3.0 / rate;
  const double critical = 2.0 / std::sqrt(1.0 / (0.1 * 0.9) + 4.0);
  const double slowed = speed / critical;
  const double stable =
      scene.step.courant_fraction * critical / (slowed + std::sqrt(slowed * slowed + 4.0));
  EXPECT_NEAR(tally(scene, state, BadParticlePolicy::stop, true).stable_step, stable, 1e-12);
}

/// Nothing more than their width without contact, without compression, and of wider domains.
TEST(TallyDomains, OtherNeedlesAreLimitedByTheirWidthAlone) {
  State state;
  Scene scene = with_needle(state, 1.0);
  const double compressed = tally(scene, state, BadParticlePolicy::stop, true).stable_step;
  const double shared = tally(scene, state, BadParticlePolicy::stop, false).stable_step;
  EXPECT_GT(shared, 1.05 * compressed);
  state.particles[0].viscous_pressure(testing::row_in(state.particles[0], 0)) = 0.0;
  EXPECT_GE(tally(scene, state, BadParticlePolicy::stop, true).stable_step, shared);
  State of_half_width;
  scene = with_needle(of_half_width, 1.0);
  Particles& particles = of_half_width.particles[0];
  particles.deformation_gradient(testing::row_in(particles, 0), 0) = 0.51;
  EXPECT_EQ(
      tally(scene, of_half_width, BadParticlePolicy::stop, true).stable_step,
      tally(scene, of_half_width, BadParticlePolicy::stop, false).stable_step
  );
}

}  // namespace
}  // namespace barreno
