// SPDX-License-Identifier: BSD-3-Clause
// Pore fluid in the poroplastic form (docs/method.md 10): against the dry law with the pressure as
// an unknown of its own, and against the closed forms of poroelasticity.
#include "wet_by_halving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

Parameters saturated(double fluid_bulk) {
  Parameters p = Sample<WetArenisca>::parameters();
  p.fluid_B0 = fluid_bulk;
  return p;
}
double effective_I1(const Point<WetArenisca>& point) {
  return trace(point.stress) + 3.0 * point.history.pore_pressure;
}

/// Crushing and shear, dilation, and back: four legs in `steps` equal increments each.
std::vector<Sym3> path(int steps) {
  const Sym3 legs[] = {
      {-0.03, -0.02, -0.01, 0.006, 0.0, 0.0},
      {0.01, -0.015, -0.01, 0.0, 0.004, 0.0},
      {0.02, 0.012, 0.02, 0.0, 0.0, 0.005},
      {-0.02, -0.01, -0.02, 0.003, 0.0, 0.0}};
  std::vector<Sym3> all;
  for (const Sym3& leg : legs)
    for (int i = 0; i < steps; ++i) all.push_back((1.0 / steps) * leg);
  return all;
}

TEST(WetArenisca, FollowsTheDryLawWithThePressureAsAnUnknown) {
  for (const double fluid : {0.1e9, 2.2e9, 10e9}) {
    Parameters p = saturated(fluid);
    p.tolerance = 1e-4;
    const WetArenisca model(p, 2300.0);
    const Arenisca skeleton(p, 2300.0);
    double last = 0.0;
    for (const int steps : {40, 160}) {
      Point<WetArenisca> point(model);
      Sym3 stress{};
      WetArenisca::History h = model.initial_history();
      double worst = 0.0;
      for (const Sym3& strain : path(steps)) {
        ASSERT_FALSE(point.apply(strain, 0.0).failed());
        step_by_halving(model, skeleton, strain, stress, h);
        const double scale = 1e8 + norm(stress);
        worst = std::fmax(worst, norm(point.stress - stress) / scale);
        worst = std::fmax(worst, std::fabs(point.history.pore_pressure - h.pore_pressure) / scale);
      }
      std::printf("Kf = %g Pa, %d steps: %.1e\n", fluid, steps, worst);
      if (steps > 40) {
        EXPECT_LT(worst, 0.5 * last + 1e-5);
      }
      last = worst;
    }
    EXPECT_LT(last, 2e-3);
  }
}

/// sqrt(J2) of the dry surface at the effective pressure, with the crush curve of dry rock.
double strength(const WetArenisca& model, double x, double evp) {
  const arenisca::Rock& rock = model.rock();
  const arenisca::Cap cap = rock.cap_at(evp);
  const double limit = rock.surface.limit(x);
  if (!cap.present || x >= cap.kappa) return limit;
  const double c = (cap.kappa - x) / (cap.kappa - cap.X);
  return limit * std::sqrt(std::fmax(0.0, 1.0 - c * c));
}

TEST(WetArenisca, YieldsOnTheDryEnvelopeAtTheEffectivePressure) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int flowed = 0;
  for (int specimen = 0; specimen < 60; ++specimen) {
    Parameters p = saturated(std::pow(10.0, 8.5 + 1.2 * (1.0 + part(random)) / 2.0));
    p.p3_crush_curve = 0.05 + 0.15 * (1.0 + part(random));
    p.matrix_bulk_modulus = (36e9) * (1.35 + 0.3 * part(random));
    const WetArenisca model(p, 2300.0);
    Point<WetArenisca> point(model);
    for (int step = 0; step < 100; ++step) {
      const double size = 2e-3;
      const Sym3 strain = {
          size * (part(random) - 0.6),
          size * (part(random) - 0.4),
          size * (part(random) - 0.6),
          size * part(random),
          size * part(random),
          size * part(random)};
      const double before = point.history.equivalent_plastic_strain;
      ASSERT_FALSE(point.apply(strain, 0.0).failed());
      const double x = effective_I1(point);
      const double evp = point.history.plastic_volume_strain;
      const double q = std::sqrt(second_invariant(deviator(point.stress)));
      const double limit = strength(model, x, evp);
      const double scale = 1e-6 * std::fmax(model.rock().surface.limit(0.0), std::fabs(x));
      ASSERT_LE(q, limit + scale);
      if (point.last.substeps == 1 && point.history.equivalent_plastic_strain > before) {
        ++flowed;
        ASSERT_NEAR(q, limit, scale);
      }
    }
  }
  EXPECT_GT(flowed, 1000);
}

/// Gassmann (1951), written for itself.
double gassmann(double Kd, double Km, double Kf, double phi) {
  const double biot = 1.0 - Kd / Km;
  return Kd + biot * biot / (phi / Kf + (1.0 - phi) / Km - Kd / (Km * Km));
}

TEST(WetArenisca, IsGassmannsRockWhileElastic) {
  for (const double fluid : {0.05e9, 2.2e9, 20e9}) {
    for (const double pressure : {0.0, 30e6, 150e6}) {
      const WetArenisca model(saturated(fluid), 2300.0);
      const double pore = 0.3 * pressure + 1e6;
      const auto start = model.initial_state(pressure + 2e6, pore);
      ASSERT_TRUE(start.possible);
      const double Kd = model.drained_moduli(start.stress, start.history).bulk;
      const arenisca::Constituents& c = model.rock().constituents;
      const double Ku = gassmann(Kd, c.matrix, c.fluid, start.history.porosity);
      EXPECT_NEAR(
          model.longitudinal_modulus(start.stress, start.history, 1.0),
          Ku + 4.0 / 3.0 * model.drained_moduli(start.stress, start.history).shear,
          1e-12 * Ku
      );
      const double h = 1e-7;
      double mean[2], fluid_pressure[2];
      for (const int side : {0, 1}) {
        Point<WetArenisca> point(model);
        point.stress = start.stress;
        point.history = start.history;
        ASSERT_FALSE(point.apply(isotropic(side == 0 ? -h : h), 0.0).failed());
        mean[side] = trace(point.stress) / 3.0;
        fluid_pressure[side] = point.history.pore_pressure;
      }
      EXPECT_NEAR(
          (mean[1] - mean[0]) / (6.0 * h), Ku, 1e-9 * Ku + 1e-8 * (pressure + 1e6) / h * 1e-7
      );
      const double skempton = (fluid_pressure[0] - fluid_pressure[1]) / (mean[1] - mean[0]);
      const double biot = 1.0 - Kd / c.matrix;
      const double expected = (Ku - Kd) / (biot * Ku);
      EXPECT_NEAR(skempton, expected, 1e-7);
    }
  }
}

/// Crushed with its fluid and drained afterwards, rock is the dry rock under the same strain: under
/// pressure alone its state is a function of the skeleton's strain.
TEST(WetArenisca, IsDryRockAfterItsFluidHasGone) {
  Parameters p = saturated(2.2e9);
  p.tolerance = 1e-5;
  const WetArenisca model(p, 2300.0);
  const Arenisca dry(p, 2300.0);
  for (const double strain : {-0.003, -0.02, -0.06}) {
    constexpr int steps = 50;
    Point<WetArenisca> wet(model);
    Point<Arenisca> other(dry);
    for (int i = 0; i < steps; ++i) {
      ASSERT_FALSE(wet.apply(isotropic(strain / steps), 0.0).failed());
      ASSERT_FALSE(other.apply(isotropic(strain / steps), 0.0).failed());
    }
    EXPECT_GT(wet.history.pore_pressure, 20e6);
    while (wet.history.gas == 0.0) {
      const PorePoint fluid = model.pore_point(wet.stress, wet.history);
      const double volume =
          -std::fmin(0.02 * fluid.porosity, fluid.fluid_mass / fluid.mass_per_volume);
      ASSERT_FALSE(model.drain(volume, wet.stress, wet.history).failed());
    }
    EXPECT_EQ(wet.history.pore_pressure, 0.0);
    EXPECT_LE(norm(wet.stress - other.stress), 1e-4 * norm(other.stress)) << strain;
    EXPECT_NEAR(
        wet.history.plastic_volume_strain, other.history.plastic_volume_strain, 3e-4 * -strain
    );
  }
}

/// One envelope for any pore pressure: sheared at a held volume from the same effective pressure,
/// rock yields at the same shear stress.
TEST(WetArenisca, YieldsAtTheEffectivePressureWhateverTheInitialPorePressure) {
  const WetArenisca model(saturated(2.2e9), 2300.0);
  const Arenisca dry(dry_rock(), 2300.0);
  const double effective = 40e6;
  Point<Arenisca> other(dry);
  other.stress = dry.initial_state(effective).stress;
  const Sym3 shear = {0.0, 0.0, 0.0, 2e-5, 0.0, 0.0};
  for (int i = 0; i < 400 && other.history.equivalent_plastic_strain == 0.0; ++i)
    ASSERT_FALSE(other.apply(shear, 0.0).failed());
  for (const double pore : {0.0, 10e6, 90e6, 500e6}) {
    const auto start = model.initial_state(effective + pore, pore);
    ASSERT_TRUE(start.possible);
    Point<WetArenisca> point(model);
    point.stress = start.stress;
    point.history = start.history;
    for (int i = 0; i < 400 && point.history.equivalent_plastic_strain == 0.0; ++i)
      ASSERT_FALSE(point.apply(shear, 0.0).failed());
    // The step in which it yields dilates a little.
    EXPECT_NEAR(point.stress.xy, other.stress.xy, 1e-5 * other.stress.xy) << pore;
    const double x = effective_I1(point);
    EXPECT_NEAR(
        std::sqrt(second_invariant(deviator(point.stress))),
        strength(model, x, point.history.plastic_volume_strain),
        1e-6 * other.stress.xy
    );
  }
}

/// Without fluid to speak of, stress and strain are those of dry rock; first order in Kf.
TEST(WetArenisca, TendsToDryRockAtFirstOrderInTheFluid) {
  const Arenisca dry(dry_rock(), 2300.0);
  double last = 0.0;
  for (const double fluid : {1e5, 1e4, 1e3}) {
    const WetArenisca model(saturated(fluid), 2300.0);
    Point<WetArenisca> wet(model);
    Point<Arenisca> other(dry);
    double worst = 0.0;
    for (const Sym3& strain : path(50)) {
      ASSERT_FALSE(wet.apply(strain, 0.0).failed());
      ASSERT_FALSE(other.apply(strain, 0.0).failed());
      worst = std::fmax(worst, norm(wet.stress - other.stress));
    }
    if (last > 0.0) {
      EXPECT_NEAR(worst, 0.1 * last, 0.02 * last);
    }
    last = worst;
  }
}

}  // namespace
}  // namespace barreno::test
