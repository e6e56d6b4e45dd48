// SPDX-License-Identifier: BSD-3-Clause
#include "step/stable_step_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace barreno {
namespace {

constexpr double density = 2500.0, cell = 0.1;

TEST(StableStepRule, IsTheOneOfTheMethodsPages) {
  StepSpec step;
  step.linear_viscosity = 0.3;
  step.quadratic_viscosity = 2.0;
  step.courant_fraction = 0.8;
  const double none = std::numeric_limits<double>::infinity();
  const StableStepRule rule(step, Mode::plane_strain, 1.5, none);
  const double modulus = 9e10, c = 6000.0, rate = -200.0;
  const double h_rate = cell * 200.0;
  EXPECT_DOUBLE_EQ(
      rule.viscous_pressure(cell, density, modulus, rate),
      density * (0.3 * c * h_rate + 2.0 * h_rate * h_rate)
  );
  EXPECT_EQ(rule.viscous_pressure(cell, density, modulus, 200.0), 0.0);
  const double fraction = 0.8 * 1.5 / std::sqrt(2.0);
  EXPECT_DOUBLE_EQ(
      rule.stable_step(cell, density, modulus, 1.0, 500.0), fraction * cell / (c + 500.0)
  );
  const double q = 0.3 * c + 2.0 * h_rate;
  const double wave = q + std::sqrt(q * q + c * c);
  EXPECT_DOUBLE_EQ(rule.stable_step(cell, density, modulus, rate, 0.0), fraction * cell / wave);
  // Alone it bears less, whatever its speed.
  const StableStepRule alone(step, Mode::plane_strain, 1.5, 0.25);
  EXPECT_DOUBLE_EQ(alone.stable_step(cell, density, modulus, 1.0, 500.0), 0.25 * cell / c);
  // The rate that a viscous pressure tells of is at least as fast as the one that made it.
  EXPECT_LE(
      rule.compression(cell, density, rule.viscous_pressure(cell, density, modulus, rate)), rate
  );
  EXPECT_EQ(rule.compression(cell, density, 0.0), 0.0);
}

}  // namespace
}  // namespace barreno
