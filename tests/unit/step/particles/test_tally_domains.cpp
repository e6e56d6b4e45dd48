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

DomainTally tally(const Scene& scene, State& state, BadParticlePolicy policy) {
  return tally_domains(scene.step, policy, state.grid, state.particles[0]);
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

}  // namespace
}  // namespace barreno
