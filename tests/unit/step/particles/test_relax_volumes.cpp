// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/relax_volumes.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

constexpr double rate_of_test = 8.0;

/// Two tiles with four particles in one cell each, all with the same shear in dt L.
State sheared(double shear) {
  State state = testing::start_in_tiles(testing::two_tiles(testing::elastic(1.0, 0.25, 1.0), 2));
  state.dormancy = {};
  Particles& particles = state.particles[0];
  EXPECT_EQ(particles.count, 8);
  for (int p = 0; p < particles.count; ++p) {
    for (int c = 0; c < particles.increment.components; ++c) particles.increment(p, c) = 0.0;
    particles.increment(p, 1) = shear;
  }
  return state;
}
int row(const Particles& particles, int tile, int k) {
  return particles.order(particles.tile_begin(tile) + k);
}
double dilatation(const Particles& particles, int p) {
  return particles.increment(p, 0) + particles.increment(p, 3) + particles.increment(p, 4);
}
void relax(const State& state) {
  relax_volumes(state.grid, state.dormancy, rate_of_test, 1.0, state.particles[0]);
}

TEST(RelaxVolumes, ParticlesOfACellComeNearerByAPartOfTheShearAndKeepTheirVolume) {
  const double shear = 0.01;
  State state = sheared(shear);
  Particles& particles = state.particles[0];
  const int larger = row(particles, 0, 1);
  const double before = std::log(1.02);
  particles.volume(larger) *= 1.02;
  relax(state);
  // |dev(dt D)| of a shear g is g / sqrt(2); three of four have no more than their share.
  const double part = rate_of_test * shear / std::sqrt(2.0);
  const double mean = 1.02 * before / (3.0 + 1.02);
  double change = 0.0;
  for (int k = 0; k < 4; ++k) {
    const int p = row(particles, 0, k);
    const double own = p == larger ? before : 0.0;
    EXPECT_NEAR(dilatation(particles, p), -part * (own - mean), 1e-16);
    EXPECT_EQ(particles.increment(p, 4), 0.0) << "the hoop strain is the radius's";
    EXPECT_EQ(particles.increment(p, 1), shear);
    change += particles.volume(p) * dilatation(particles, p);
  }
  EXPECT_NEAR(change, 0.0, 1e-17);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(dilatation(particles, row(particles, 1, k)), 0.0);
}

TEST(RelaxVolumes, NothingMovesWithoutShearAndNothingBeyondAFifth) {
  for (const double shear : {0.0, 10.0}) {
    State state = sheared(shear);
    Particles& particles = state.particles[0];
    const int larger = row(particles, 0, 0);
    particles.volume(larger) *= 1.1;
    const double off = std::log(1.1) * (1.0 - 1.1 / 4.1);
    relax(state);
    EXPECT_NEAR(dilatation(particles, larger), shear > 0.0 ? -most_relaxed * off : 0.0, 1e-16);
  }
}

TEST(RelaxVolumes, TornParticlesAreNotSeen) {
  State state = sheared(0.01);
  Particles& particles = state.particles[0];
  particles.volume(row(particles, 0, 2)) *= std::exp(1.01 * intact_volume);
  relax(state);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(dilatation(particles, row(particles, 0, k)), 0.0);
}

TEST(RelaxVolumes, ParticlesOfTilesThatAreLeftStay) {
  State state = sheared(0.01);
  Particles& particles = state.particles[0];
  for (int tile = 0; tile < 2; ++tile) particles.volume(row(particles, tile, 0)) *= 1.01;
  state.dormancy.on = true;
  state.dormancy.stays = ArrayView<unsigned char>("stays", 2);
  state.dormancy.stays(0) = is_in_its_step;
  relax(state);
  EXPECT_EQ(dilatation(particles, row(particles, 0, 0)), 0.0);
  EXPECT_LT(dilatation(particles, row(particles, 1, 0)), 0.0);
}

}  // namespace
}  // namespace barreno
