// SPDX-License-Identifier: BSD-3-Clause
// Why a particle is taken out of the run, and what the ledger says of it.
#include "step/order/remove_lost.hpp"
#include "unit/step/order/four_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace barreno {
namespace {

using testing::four_particles;
using testing::put;

int cause_of(const State& state, int row) {
  return RemovalRule(state.grid, state.particles[0]).cause_of(row);
}

TEST(RemoveLost, EveryCauseHasItsOwnName) {
  State state = testing::start_alone(four_particles());
  Particles& particles = state.particles[0];
  EXPECT_EQ(cause_of(state, 0), -1);
  put(particles, 0, 3.0, -1e-300);
  EXPECT_EQ(cause_of(state, 0), static_cast<int>(RemovalCause::left_grid));
  for (const Fault fault : {Fault::failed, Fault::expanded, Fault::inverted}) {
    particles.fault(0) = fault;  // counts before the place
    EXPECT_EQ(fault_of_cause(cause_of(state, 0)), fault);
  }
  particles.velocity(0, 1) = std::numeric_limits<double>::quiet_NaN();  // before all others
  EXPECT_EQ(cause_of(state, 0), static_cast<int>(RemovalCause::not_finite));
  EXPECT_EQ(fault_of_cause(cause_of(state, 0)), Fault::none);
}

TEST(RemoveLost, TheLedgerTakesWhatGoesAndTheLastRowsFillTheGaps) {
  State state = testing::start_alone(four_particles());
  Particles& particles = state.particles[0];
  for (int row = 0; row < 4; ++row) {
    particles.mass(row) = 1.0 + row;
    particles.velocity(row, 0) = 3.0;
    particles.velocity(row, 1) = 4.0;
  }
  put(particles, 0, 17.0, 1.0);
  particles.position(2, 0) = std::numeric_limits<double>::infinity();
  const double mass = state.ledger.mass, momentum = state.ledger.momentum;
  remove_lost(state.grid, particles, state.ledger);
  ASSERT_EQ(particles.count, 2);
  EXPECT_FALSE(particles.sorted);
  EXPECT_EQ(particles.id(0), 4);  // the last row has come to the place of the first
  EXPECT_EQ(particles.mass(0), 4.0);
  EXPECT_EQ(particles.id(1), 2);
  EXPECT_EQ(particles.mass(1), 2.0);
  const auto& left = state.ledger.removed[static_cast<std::size_t>(RemovalCause::left_grid)];
  EXPECT_EQ(left.count, 1.0);
  EXPECT_EQ(left.mass, 1.0);
  EXPECT_EQ(left.momentum, 4.0);
  EXPECT_EQ(left.kinetic, 12.5);
  const auto& lost = state.ledger.removed[static_cast<std::size_t>(RemovalCause::not_finite)];
  EXPECT_EQ(lost.count, 1.0);
  EXPECT_EQ(lost.mass, 3.0);
  EXPECT_EQ(lost.kinetic, 37.5);  // its velocity is finite, its place is not
  EXPECT_EQ(state.ledger.mass, mass - 4.0);
  EXPECT_EQ(state.ledger.momentum, momentum - 16.0);
}

TEST(RemoveLost, ARigidBodyLosesParticlesWithoutATally) {
  State state = testing::start_alone(four_particles());
  Particles& particles = state.particles[0];
  particles.rigid = true;
  put(particles, 3, 3.0, 17.0);
  const double mass = state.ledger.mass;
  remove_lost(state.grid, particles, state.ledger);
  EXPECT_EQ(particles.count, 3);
  EXPECT_EQ(state.ledger.mass, mass);
}

}  // namespace
}  // namespace barreno
