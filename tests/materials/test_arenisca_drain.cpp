// SPDX-License-Identifier: BSD-3-Clause
/// Fluid that flows into and out of Arenisca.

#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;
using Rock = Point<GeneralArenisca>;

/// The demonstration set with water.
Parameters wet() {
  Parameters p = wet_rock();
  p.tolerance = 1e-6;
  return p;
}
/// The same with moduli that do not depend on pressure.
Parameters steady() {
  Parameters p = wet();
  p.B1 = p.B2 = 0.0;
  p.matrix_bulk_modulus = 36e9;
  return p;
}
PorePoint fluid(const Rock& rock) {
  return rock.model.pore_point(rock.stress, rock.history);
}
/// Starts at rest under the fluid's own pressure.
Rock virgin(const GeneralArenisca& model) {
  Rock rock(model);
  const auto start = model.initial_state(0.0);
  rock.stress = start.stress;
  rock.history = start.history;
  return rock;
}
template <class Any>
void strain(Any& rock, const Sym3& total, int steps) {
  for (int i = 0; i < steps; ++i) {
    ASSERT_FALSE(rock.apply((1.0 / steps) * total, 1e-6).failed());
  }
}
/// Brings the fluid to a pressure, in so many parts and then to the last pascal.
/// @return plastic work
double bring_to(Rock& rock, double pressure, int parts) {
  double work = 0.0;
  for (int left = parts; left > -60; --left) {
    const PorePoint at = fluid(rock);
    const double rise = pressure - at.pressure;
    if (std::fabs(rise) <= 1e-3) break;
    const Outcome outcome =
        rock.model.drain(rise * at.storage / std::max(left, 1), rock.stress, rock.history);
    EXPECT_FALSE(outcome.failed());
    work += outcome.plastic_work;
  }
  return work;
}
/// Largest difference of stresses over the size of the second.
double apart(const Sym3& a, const Sym3& b) {
  return norm(a - b) / norm(b);
}
/// Undrained strain, then the pressure let out, against dry rock under the same strain.
double from_drained(const Parameters& p, const Sym3& total) {
  const GeneralArenisca model(p, 2300.0);
  Rock rock = virgin(model);
  strain(rock, total, 20);
  EXPECT_GT(fluid(rock).pressure, 1e6);
  bring_to(rock, 0.0, 100);
  Parameters q = p;
  q.fluid_B0 = 0.0;
  const Arenisca dry(q, 2300.0);
  Point<Arenisca> drained(dry);
  strain(drained, total, 20);
  return apart(rock.stress, drained.stress);
}

/// Elastic: exactly that of dry rock, whatever the moduli do (1e-5 is what dry rock's own steps
/// miss). A shift of the stress by dp instead of alpha dp would give 6.4 instead of 8 GPa.
TEST(AreniscaDrain, ElasticRockHasTheDrainedLimit) {
  const Sym3 small{-4e-4, -3e-4, -3e-4, 1e-4, 0.0, -1e-4};
  EXPECT_LE(from_drained(steady(), small), 1e-12);
  EXPECT_LE(from_drained(steady(), 5.0 * small), 1e-12);
  EXPECT_LE(from_drained(wet(), small), 1e-6);
  EXPECT_LE(from_drained(wet(), 5.0 * small), 2e-5);
}

/// Crushed: the way there was another. Steady moduli: 1 % after 8 % of strain. With moduli that
/// rise with pressure undrained rock crushes at less strain than drained rock does (X_sat = X_dry
/// Ks/Kd is a rule for steady moduli), and a quarter of the stress is missing afterwards.
TEST(AreniscaDrain, CrushedRockIsNearTheDrainedLimit) {
  EXPECT_LE(from_drained(steady(), isotropic(-0.01)), 2e-3);
  EXPECT_LE(from_drained(steady(), isotropic(-0.08 / 3.0)), 0.012);
  EXPECT_LE(from_drained(wet(), isotropic(-0.08 / 3.0)), 0.3);
}

/// Virgin rock out of which fluid has flowed is virgin rock under less pressure: the response to
/// strain is the same in every digit, elastic and not.
TEST(AreniscaDrain, VirginRockStaysVirgin) {
  Parameters p = wet(), q = wet();
  p.fluid_pressure_initial = 40e6;
  const GeneralArenisca model(p, 2300.0);
  Rock drawn = virgin(model);
  bring_to(drawn, 25e6, 3);
  EXPECT_EQ(drawn.history.plastic_volume_strain, 0.0);
  // The stress about the centre is not zero: drawing the fluid leaves x = I1 + 3 p_c < 0.
  const arenisca::PointRock point(model.rock(), 1.0, drawn.history.fluid_mass_ratio);
  q.fluid_pressure_initial = point.fluid.initial_pressure;
  const GeneralArenisca other(q, 2300.0);
  Rock fresh = virgin(other);
  fresh.stress = drawn.stress;
  for (const double a : {1e-4, 2e-3, 2e-3, -1e-3}) {
    const Sym3 more = a * Sym3{-1.0, -0.6, -0.4, 0.3, 0.1, 0.0};
    strain(drawn, more, 1);
    strain(fresh, more, 1);
    EXPECT_LE(apart(drawn.stress, fresh.stress), 1e-12);
    EXPECT_NEAR(drawn.history.pore_pressure / fresh.history.pore_pressure, 1.0, 1e-11);
  }
}

/// Biot's tangents at full pores, with the drained modulus of the state: exact whatever Kd(x) is.
TEST(AreniscaDrain, StorageIsBiots) {
  Parameters p = wet();
  p.fluid_pressure_initial = 60e6;
  const GeneralArenisca model(p, 2300.0);
  Rock rock = virgin(model);
  strain(rock, isotropic(-1.5e-3), 10);
  const double x = trace(rock.stress) + 3.0 * 60e6;
  const double drained = model.rock().elasticity.moduli_at(x, 0.0).bulk;
  EXPECT_GT(drained, 10e9);
  const PorePoint at = fluid(rock);
  const double alpha = 1.0 - drained / 36e9, phi = -std::expm1(-0.22);
  EXPECT_NEAR(at.biot, alpha, 1e-12);
  EXPECT_NEAR(at.storage / (phi / 2.2e9 + (alpha - phi) / 36e9), 1.0, 1e-12);
  EXPECT_NEAR(at.mass_per_volume * phi, 1.0, 1e-12);
  // The way back to the centre at that rate would be another pressure.
  const double undrained = drained + alpha * alpha / at.storage;
  const double skempton = alpha / at.storage / undrained;
  EXPECT_GT(at.pressure - 60e6, 1.1 * skempton * -x / 3.0);
}

/// Rock that has lost fluid under load and is unloaded has a gas gap: no pressure, and fluid comes
/// in without any until the gap is full.
TEST(AreniscaDrain, GapFillsWithoutPressure) {
  const GeneralArenisca model(steady(), 2300.0);
  Rock rock = virgin(model);
  strain(rock, isotropic(-2e-3), 10);
  bring_to(rock, 0.0, 10);
  strain(rock, isotropic(1.5e-3), 10);
  PorePoint at = fluid(rock);
  EXPECT_EQ(at.pressure, 0.0);
  // Grains of 36 GPa, pores that opened by alpha times the strain.
  const double gap = (1.0 - 8.0 / 36.0) * 4.5e-3;
  const double gas = 5e-5 * 2.2e9;
  EXPECT_NEAR(at.storage * gas / gap, 1.0, 2e-2);
  const Sym3 stress = rock.stress;
  ASSERT_FALSE(model.drain(0.98 * gap, rock.stress, rock.history).failed());
  EXPECT_EQ(fluid(rock).pressure, 0.0);
  EXPECT_LE(apart(rock.stress, stress), 1e-12);
  ASSERT_FALSE(model.drain(0.1 * gap, rock.stress, rock.history).failed());
  EXPECT_GT(fluid(rock).pressure, 1e6);
}

/// Fluid pressed into confined, sheared rock weakens it until it flows: the state stays on the
/// surface, dissipation is not negative, and one flow is as many small ones.
TEST(AreniscaDrain, InjectedRockFlows) {
  Parameters p = wet();
  p.fluid_pressure_initial = 20e6;
  p.tolerance = 1e-4;
  const GeneralArenisca model(p, 2300.0);
  Rock sheared = virgin(model);
  strain(sheared, isotropic(-5e-4) + Sym3{0.0, 0.0, 0.0, 1.8e-3, 0.0, 0.0}, 10);
  EXPECT_EQ(sheared.history.equivalent_plastic_strain, 0.0);
  const PorePoint at = fluid(sheared);
  const double volume = 80e6 * at.storage;
  Rock once = sheared, often = sheared;
  const Outcome outcome = model.drain(volume, once.stress, once.history);
  ASSERT_FALSE(outcome.failed());
  EXPECT_GT(outcome.plastic_work, 0.0);
  EXPECT_LT(once.stress.xy, 0.95 * sheared.stress.xy);
  double work = 0.0;
  const double mass = volume * at.mass_per_volume;
  for (int i = 0; i < 200; ++i) {
    const Outcome part =
        model.drain(mass / 200.0 / fluid(often).mass_per_volume, often.stress, often.history);
    ASSERT_FALSE(part.failed());
    EXPECT_GE(part.plastic_work, 0.0);
    work += part.plastic_work;
  }
  EXPECT_NEAR(once.history.fluid_mass_ratio, often.history.fluid_mass_ratio, 1e-13);
  EXPECT_LE(apart(once.stress, often.stress), 5e-3);
  EXPECT_NEAR(outcome.plastic_work / work, 1.0, 0.02);
  const Sym3 before = once.stress;
  ASSERT_FALSE(once.apply(Sym3{}, 1e-6).failed());
  EXPECT_LE(apart(once.stress, before), 1e-6);
}

/// Nothing flows in rock without fluid, without pores, or in the published form.
TEST(AreniscaDrain, WhatHoldsNoFluidThatFlows) {
  std::vector<Parameters> rocks(3, wet());
  rocks[0].fluid_B0 = 0.0;
  rocks[0].T1_rate_dependence = 1e-6;
  rocks[1].p3_crush_curve = 0.0;
  rocks[2].backstress_strain = Arenisca::plastic_backstress;
  rocks[2].undrained_moduli = Arenisca::arenisca3_moduli;
  for (const Parameters& p : rocks) {
    const GeneralArenisca model(p, 2300.0);
    Rock rock = virgin(model);
    strain(rock, isotropic(-1e-4), 1);
    const Sym3 stress = rock.stress;
    EXPECT_EQ(fluid(rock).storage, 0.0);
    EXPECT_EQ(model.drain(1e-6, rock.stress, rock.history).status, Status::bad_input);
    EXPECT_EQ(norm(rock.stress - stress), 0.0);
  }
}

/// Pores that are emptied and then crushed shut: their walls press on each other, but there is no
/// fluid with a pressure, and none comes in.
TEST(AreniscaDrain, EmptyPoresHaveNoPressure) {
  const GeneralArenisca model(wet(), 2300.0);
  Rock rock = virgin(model);
  strain(rock, isotropic(-0.02), 40);
  EXPECT_GT(rock.history.pore_pressure, 1e6);
  const PorePoint full = fluid(rock);
  ASSERT_FALSE(
      model.drain(-full.fluid_mass / full.mass_per_volume, rock.stress, rock.history).failed()
  );
  EXPECT_EQ(rock.history.fluid_mass_ratio, 0.0);
  for (int i = 0; i < 40; ++i) {
    strain(rock, isotropic(-0.01), 20);
    EXPECT_EQ(rock.history.pore_pressure, 0.0);
    EXPECT_EQ(fluid(rock).pressure, 0.0);
  }
  EXPECT_LT(trace(rock.stress), -3e9);
  EXPECT_EQ(fluid(rock).storage, 0.0);
  EXPECT_EQ(model.drain(1e-6, rock.stress, rock.history).status, Status::bad_input);
}

/// Overstress is not the fluid's: it stays.
TEST(AreniscaDrain, OverstressStays) {
  Parameters p = wet();
  p.T1_rate_dependence = 1e-4;
  const GeneralArenisca model(p, 2300.0);
  Rock rock = virgin(model);
  strain(rock, Sym3{-0.03, 0.0, 0.0, 0.015, 0.0, 0.0}, 20);
  const GeneralArenisca::History before = rock.history;
  EXPECT_GT(std::fabs(before.overstress_xy), 1e6);
  bring_to(rock, 0.5 * before.pore_pressure, 5);
  EXPECT_EQ(rock.history.overstress_xx, before.overstress_xx);
  EXPECT_EQ(rock.history.overstress_xy, before.overstress_xy);
}

/// Rock at rest with a pore pressure of its own is where slow confinement leads: undrained, then
/// drained at fixed strain and pressed again until both pressures are there.
TEST(AreniscaDrain, StartsWithAPorePressureOfItsOwn) {
  const GeneralArenisca model(wet(), 2300.0);
  for (const double pore : {0.5e6, 10e6, 29e6}) {
    const auto start = model.initial_state(30e6, pore);
    EXPECT_TRUE(start.possible);
    EXPECT_LE(norm(start.stress + isotropic(30e6)), 1e-6);
    EXPECT_NEAR(start.history.pore_pressure, pore, 1e-2);
    Rock rock(model);
    const auto undrained = model.initial_state(30e6);
    rock.stress = undrained.stress;
    rock.history = undrained.history;
    for (int round = 0; round < 60; ++round) {
      bring_to(rock, pore, 1);
      const double left = -90e6 - trace(rock.stress);
      const double shear = model.drained_moduli(rock.stress, rock.history).shear;
      const double axial = model.longitudinal_modulus(rock.stress, rock.history, 1.0);
      strain(rock, isotropic(left / (9.0 * (axial - 4.0 / 3.0 * shear))), 1);
    }
    EXPECT_NEAR(trace(rock.stress), -90e6, 10.0);
    EXPECT_NEAR(fluid(rock).pressure, pore, 10.0);
    EXPECT_NEAR(rock.history.fluid_mass_ratio, start.history.fluid_mass_ratio, 1e-7);
    EXPECT_NEAR(fluid(rock).porosity, start.history.porosity, 1e-7);
  }
  EXPECT_FALSE(model.initial_state(30e6, 31e6).possible);
  EXPECT_FALSE(model.initial_state(30e6, -1.0).possible);
}

}  // namespace
}  // namespace barreno::test
