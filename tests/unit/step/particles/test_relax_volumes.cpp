// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/relax_volumes.hpp"
#include "support/sheared_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::dilatation;
using testing::row_in_cell;
using testing::sheared_cells;

constexpr double rate_of_test = 8.0;

void relax_cells(const State& state) {
  relax_volumes(state.grid, state.dormancy, rate_of_test, 1.0, state.particles[0]);
}

TEST(RelaxVolumes, ParticlesOfACellComeNearerByAPartOfTheShearAndKeepTheirVolume) {
  const double shear = 0.01;
  State state = sheared_cells(shear);
  Particles& particles = state.particles[0];
  const int larger = row_in_cell(particles, 0, 1);
  const double before = std::log(1.02);
  particles.volume(larger) *= 1.02;
  relax_cells(state);
  // |dev(dt D)| of a shear g is g / sqrt(2); three of four have no more than their share.
  const double part = rate_of_test * shear / std::sqrt(2.0);
  const double mean = 1.02 * before / (3.0 + 1.02);
  double change = 0.0;
  for (int k = 0; k < 4; ++k) {
    const int p = row_in_cell(particles, 0, k);
    const double own = p == larger ? before : 0.0;
    EXPECT_NEAR(dilatation(particles, p), -part * (own - mean), 1e-16);
    EXPECT_EQ(particles.increment(p, 4), 0.0) << "the hoop strain is the radius's";
    EXPECT_EQ(particles.increment(p, 1), shear);
    change += particles.volume(p) * dilatation(particles, p);
  }
  EXPECT_NEAR(change, 0.0, 1e-17);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(dilatation(particles, row_in_cell(particles, 1, k)), 0.0);
}

TEST(RelaxVolumes, NothingMovesWithoutShearAndNothingBeyondAFifth) {
  for (const double shear : {0.0, 10.0}) {
    State state = sheared_cells(shear);
    Particles& particles = state.particles[0];
    const int larger = row_in_cell(particles, 0, 0);
    particles.volume(larger) *= 1.1;
    const double off = std::log(1.1) * (1.0 - 1.1 / 4.1);
    relax_cells(state);
    EXPECT_NEAR(dilatation(particles, larger), shear > 0.0 ? -most_relaxed * off : 0.0, 1e-16);
  }
}

TEST(RelaxVolumes, TornParticlesAreNotSeen) {
  State state = sheared_cells(0.01);
  Particles& particles = state.particles[0];
  particles.volume(row_in_cell(particles, 0, 2)) *= std::exp(1.01 * intact_volume);
  relax_cells(state);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(dilatation(particles, row_in_cell(particles, 0, k)), 0.0);
}

TEST(RelaxVolumes, ParticlesOfTilesThatAreLeftStay) {
  State state = sheared_cells(0.01);
  Particles& particles = state.particles[0];
  for (int tile = 0; tile < 2; ++tile) particles.volume(row_in_cell(particles, tile, 0)) *= 1.01;
  testing::leave_first_tile(state);
  relax_cells(state);
  EXPECT_EQ(dilatation(particles, row_in_cell(particles, 0, 0)), 0.0);
  EXPECT_LT(dilatation(particles, row_in_cell(particles, 1, 0)), 0.0);
}

}  // namespace
}  // namespace barreno
