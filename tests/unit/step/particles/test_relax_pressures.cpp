// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/relax_pressures.hpp"
#include "support/sheared_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace barreno {
namespace {

using testing::dilatation;
using testing::row_in_cell;

constexpr double modulus_of_test = 4.0, shear_of_test = 1e-3;

/// Cells whose particles are under these pressures.
State pressed(const std::vector<double>& pressures) {
  State state = testing::sheared_cells(shear_of_test);
  Particles& particles = state.particles[0];
  for (int tile = 0; tile < 2; ++tile)
    for (int k = 0; k < 4; ++k) {
      const int p = row_in_cell(particles, tile, k);
      for (int c = 0; c < 3; ++c) particles.stress(p, c) = -pressures[static_cast<std::size_t>(k)];
      particles.longitudinal_modulus(p) = modulus_of_test;
    }
  return state;
}
void make_too_dense(Particles& particles, int p) {
  particles.volume(p) /= 1.01 * too_dense;
}
void equalise(const State& state) {
  relax_pressures(state.grid, state.dormancy, 1.0, state.particles[0]);
}
/// Norm of the deviator of a shear, and the part of the differences that it takes away.
double part() {
  return pressure_relaxation * shear_of_test / std::sqrt(2.0);
}

TEST(RelaxPressures, CellOfADenseRowComesNearerToOnePressureAndKeepsItsVolume) {
  const std::vector<double> pressures{0.3, 0.0, -0.1, 0.1};
  State state = pressed(pressures);
  Particles& particles = state.particles[0];
  make_too_dense(particles, row_in_cell(particles, 0, 0));
  equalise(state);
  const double v = 1.0 / (1.01 * too_dense);  // over that of the others
  const double common = (0.3 * v + 0.0 - 0.1 + 0.1) / (v + 3.0);
  double change = 0.0, work = 0.0;
  for (int k = 0; k < 4; ++k) {
    const int p = row_in_cell(particles, 0, k);
    const double own = pressures[static_cast<std::size_t>(k)];
    EXPECT_NEAR(dilatation(particles, p), part() * (own - common) / modulus_of_test, 1e-16);
    EXPECT_EQ(particles.increment(p, 4), 0.0) << "the hoop strain is the radius's";
    EXPECT_EQ(particles.increment(p, 1), shear_of_test);
    change += particles.volume(p) * dilatation(particles, p);
    work += own * particles.volume(p) * dilatation(particles, p);
  }
  EXPECT_NEAR(change, 0.0, 1e-17);
  EXPECT_GT(work, 0.0) << "the particles give energy, and get none";
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(dilatation(particles, row_in_cell(particles, 1, k)), 0.0)
        << "a cell without a dense row";
}

TEST(RelaxPressures, VoidsCloseFirst) {
  State state = pressed({0.3, 0.1, 0.1, 0.0});
  Particles& particles = state.particles[0];
  const int dense = row_in_cell(particles, 0, 0), open = row_in_cell(particles, 0, 3);
  make_too_dense(particles, dense);
  particles.longitudinal_modulus(open) = 1e-3 * modulus_of_test;
  equalise(state);
  // The common pressure is next to none: the solid rows expand by what the void gives.
  for (int k = 0; k < 3; ++k) {
    const int p = row_in_cell(particles, 0, k);
    const double pressure = -particles.stress(p, 0);
    EXPECT_NEAR(
        dilatation(particles, p),
        part() * pressure / modulus_of_test,
        2e-3 * part() / modulus_of_test
    );
  }
  EXPECT_LT(particles.volume(open) * dilatation(particles, open), 0.0);
}

TEST(RelaxPressures, NoVolumeChangesByMoreThanATwentiethInAStep) {
  State state = pressed({50.0, 0.0, 0.0, 0.0});
  Particles& particles = state.particles[0];
  const int dense = row_in_cell(particles, 0, 0);
  make_too_dense(particles, dense);
  equalise(state);
  EXPECT_NEAR(dilatation(particles, dense), largest_volume_change, 1e-15);
}

TEST(RelaxPressures, ParticlesOfTilesThatAreLeftStay) {
  State state = pressed({0.3, 0.0, 0.0, 0.0});
  Particles& particles = state.particles[0];
  for (int tile = 0; tile < 2; ++tile) make_too_dense(particles, row_in_cell(particles, tile, 0));
  testing::leave_first_tile(state);
  equalise(state);
  EXPECT_EQ(dilatation(particles, row_in_cell(particles, 0, 0)), 0.0);
  EXPECT_GT(dilatation(particles, row_in_cell(particles, 1, 0)), 0.0);
}

}  // namespace
}  // namespace barreno
