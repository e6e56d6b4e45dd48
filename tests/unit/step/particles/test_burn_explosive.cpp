// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/burn_explosive.hpp"

#include <gtest/gtest.h>

#include <barreno/models/jwl_explosive.hpp>
#include <barreno/models/linear_elastic.hpp>
namespace barreno {
namespace {

/// F = D (t - t_b) / (k h), from its least on; before, there is no artificial viscosity.
TEST(BurnExplosive, BurnsAcrossTheFrontOnceItIsLit) {
  JwlExplosive::Parameters parameters;
  parameters.detonation_speed = 8000.0;
  parameters.a = 5e11;
  parameters.b = 8e9;
  parameters.r1 = 4.2;
  parameters.r2 = 1.1;
  parameters.omega = 0.34;
  parameters.energy = 9.5e9;
  parameters.burn_width = 2.5;
  const JwlExplosive explosive(parameters, 1700.0);
  JwlExplosive::History history;
  history.lighting_time = 2e-6;
  const double cell = 1e-3;
  EXPECT_EQ(burn_explosive(explosive, 1.9e-6, cell, 3e8, history), 0.0);
  EXPECT_EQ(history.burn, 0.0);
  EXPECT_EQ(burn_explosive(explosive, 2.1e-6, cell, 3e8, history), 3e8);
  EXPECT_NEAR(history.burn, 8000.0 * 0.1e-6 / (2.5 * cell), 1e-12);
  burn_explosive(explosive, 3e-6, cell, 3e8, history);
  EXPECT_EQ(history.burn, 1.0);
}

TEST(BurnExplosive, OtherModelsKeepTheirViscosity) {
  const LinearElastic rock(LinearElastic::Parameters{}, 2e3);
  LinearElastic::History history;
  EXPECT_EQ(burn_explosive(rock, 1e-6, 1e-3, 3e8, history), 3e8);
}

}  // namespace
}  // namespace barreno
