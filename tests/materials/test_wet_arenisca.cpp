// SPDX-License-Identifier: BSD-3-Clause
// Pore fluid in the poroplastic form (docs/method.md 10): against the dry law with the pressure as
// an unknown of its own, and against the closed forms of poroelasticity.
#include "sample_models.hpp"

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

/// Volume that grains and fluid take less the volume there is, over the volume at the start.
struct Balance {
  const WetArenisca& model;
  const Sym3 strain;
  const Sym3 begin;  ///< effective stress
  const WetArenisca::History h;
  Sym3 end{};
  Arenisca::History dry{};

  /// With this rise of the pressure; leaves stress and history of the dry rock behind.
  double excess(const Arenisca& skeleton, double rise) {
    const arenisca::Constituents& c = model.rock().constituents;
    Increment increment;
    increment.strain = strain + isotropic(rise / (3.0 * c.matrix));
    end = begin;
    dry = {h.plastic_volume_strain, h.equivalent_plastic_strain};
    EXPECT_FALSE(skeleton.update(increment, end, dry).failed());
    const double solid = 1.0 - h.porosity, fluid = h.porosity - h.gas;
    const double load = -trace(end - begin) / 3.0;
    return solid * std::exp(-(load / solid + rise) / c.matrix) + fluid * std::exp(-rise / c.fluid) -
           std::exp(trace(strain));
  }
};

/// A step of wet rock by halving the rise of the pressure around the dry law: its own solution of
/// the same equations, without their derivatives.
void step_by_halving(
    const WetArenisca& model,
    const Arenisca& skeleton,
    const Sym3& strain,
    Sym3& stress,
    WetArenisca::History& h
) {
  constexpr int halvings = 80;
  const double p = h.pore_pressure;
  Balance balance{model, strain, stress + isotropic(p), h};
  double low = -p, high = 20e9;
  if (balance.excess(skeleton, low) <= 0.0) high = low;  // gas
  for (int i = 0; i < halvings && high > low; ++i) {
    const double rise = 0.5 * (low + high);
    (balance.excess(skeleton, rise) > 0.0 ? low : high) = rise;
  }
  balance.excess(skeleton, high);
  const arenisca::Constituents& c = model.rock().constituents;
  const double solid = 1.0 - h.porosity, fluid = h.porosity - h.gas;
  const double load = -trace(balance.end - balance.begin) / 3.0, volume = std::exp(trace(strain));
  h.porosity = 1.0 - solid * std::exp(-(load / solid + high) / c.matrix) / volume;
  h.gas = std::fmax(0.0, h.porosity - fluid * std::exp(-high / c.fluid) / volume);
  h.pore_pressure = p + high;
  if (h.pore_pressure > 0.0) h.gas = 0.0;
  h.plastic_volume_strain = balance.dry.plastic_volume_strain;
  h.equivalent_plastic_strain = balance.dry.equivalent_plastic_strain;
  stress = balance.end - isotropic(h.pore_pressure);
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

/// Rubble that was blown to twenty times its volume holds its water as drops (docs/method.md,
/// 10.3): rock of the card berea_sandstone_bounded, as a particle of a run had it.
struct Rubble {
  WetArenisca::History h;
  Sym3 stress, strain;
};
Rubble rubble_of_a_run() {
  Rubble r;
  r.h.plastic_volume_strain = 0x1.81f9359d7338dp+1;
  r.h.equivalent_plastic_strain = 0x1.16173d130b5e3p+4;
  r.h.fluid_mass_ratio = 0x1.f14059c38f18ep-1;
  r.h.porosity = 0x1.ebcaca2a7691ep-1;
  r.h.gas = 0x1.e6dc7454a9bb2p-1;
  r.stress = {
      0x1.514afdac361f5p+20,
      -0x1.2b175cf90e6f3p+18,
      0x1.5e1ce43d01c91p+17,
      0x1.29b206729e653p+21,
      0.0,
      0.0};
  r.strain = {
      0x1.9a3ab449cc8b1p-12,
      -0x1.a02d42d947e09p-13,
      -0x1.d12602136a5bcp-16,
      0x1.be7b203e71f4cp-11,
      0.0,
      0.0};
  return r;
}
Parameters bounded_berea() {
  Parameters p = saturated(2.25e9);
  p.PEAKI1 = 5.78e6;
  p.FSLOPE = 0.627;
  p.STREN = 128.5e6;
  p.YSLOPE = 0.0724;
  p.dilatancy_limit = 0.05;
  p.dilatancy_pressure = 60e6;
  p.CR = 0.593;
  p.B0 = 6.74e9;
  p.B1 = 28.6e9;
  p.B2 = 264e6;
  p.G0 = 5.703e9;
  p.G1 = 0.17;
  p.G2 = 0.03;
  p.p0_crush_curve = -1.2244e9;
  p.p1_crush_curve = 5.95e-10;
  p.p3_crush_curve = 0.2231;
  return p;
}

/// Where gas is left the answer is known: stress, plastic strain and what is dissipated are those
/// of dry rock, no work is more than stress times strain, grains follow the stress and the fluid
/// keeps its volume.
/// @param stress, h  before the step
void expect_dry_step(
    const Parameters& p, const Sym3& strain, const Sym3& stress, const WetArenisca::History& h
) {
  const WetArenisca model(p, 2320.0);
  const Arenisca skeleton(p, 2320.0);
  Increment increment;
  increment.strain = strain;
  Sym3 wet = stress, dry = stress;
  WetArenisca::History after = h;
  Arenisca::History dry_after{h.plastic_volume_strain, h.equivalent_plastic_strain};
  const Outcome outcome = model.update(increment, wet, after);
  const Outcome expected = skeleton.update(increment, dry, dry_after);
  ASSERT_FALSE(expected.failed());
  ASSERT_FALSE(outcome.failed());
  const double size = norm(stress) + norm(dry) + 8e9 * norm(strain);
  EXPECT_LE(norm(wet - dry), 1e-12 * size);
  const double path = norm(strain);
  EXPECT_NEAR(after.plastic_volume_strain, dry_after.plastic_volume_strain, 1e-10 * path + 1e-15);
  EXPECT_NEAR(
      after.equivalent_plastic_strain, dry_after.equivalent_plastic_strain, 1e-10 * path + 1e-14
  );
  EXPECT_NEAR(outcome.plastic_work, expected.plastic_work, 1e-11 * size * path);
  EXPECT_LE(std::fabs(outcome.elastic_work + outcome.plastic_work), size * path);
  EXPECT_EQ(after.pore_pressure, 0.0);
  const double solid = 1.0 - h.porosity, smaller = std::exp(-trace(strain));
  const double matrix = model.rock().constituents.matrix;
  const double load = -trace(dry - stress) / (3.0 * matrix);
  // Of each substep the grains' part is that at its start.
  const double slack = 2.0 * size / matrix * path + 1e-14;
  EXPECT_NEAR(1.0 - after.porosity, solid * std::exp(-load / solid) * smaller, slack);
  EXPECT_NEAR(after.porosity - after.gas, (h.porosity - h.gas) * smaller, 1e-9);
}

TEST(WetArenisca, RubbleOfARunIsDryRock) {
  const Rubble r = rubble_of_a_run();
  expect_dry_step(bounded_berea(), r.strain, r.stress, r.h);
}

/// The same beside it: more and less porosity, water and dilation, other stresses and strains, in
/// both directions.
TEST(WetArenisca, RubbleBesideThatOfARunIsDryRock) {
  const Parameters p = bounded_berea();
  const Arenisca skeleton(p, 2320.0);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> symmetric(-1.0, 1.0);
  const auto power = [&](double from, double to) {
    return from * std::pow(to / from, 0.5 + 0.5 * symmetric(random));
  };
  const auto tensor = [&](double size) {
    const auto part = [&] { return size * symmetric(random); };
    return Sym3{part(), part(), part(), part(), part(), part()};
  };
  for (int i = 0; i < 3000; ++i) {
    const Rubble r = rubble_of_a_run();
    WetArenisca::History h = r.h;
    const double solid = power(0.02, 0.4);
    h.porosity = 1.0 - solid;
    h.gas = h.porosity - solid * power(1e-4, 0.3);
    h.plastic_volume_strain = power(0.05, 4.0);
    // A stress that the rock can bear: that after a step of dry rock.
    Sym3 stress{};
    Arenisca::History dry{h.plastic_volume_strain, 1.0};
    Increment increment;
    increment.strain = tensor(power(1e-5, 1e-3));
    ASSERT_FALSE(skeleton.update(increment, stress, dry).failed());
    const double size = power(1e-7, 1e-2);
    const Sym3 strain = tensor(size) - isotropic(0.5 * size * symmetric(random));
    for (const double way : {1.0, -1.0}) {
      SCOPED_TRACE(i);
      expect_dry_step(p, way * strain, stress, h);
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
  }
}

/// Pressed rock with hardly any water, which is no rubble: grains alone are stiffer than the volume
/// that they take, too.
TEST(WetArenisca, PressedRockWithATraceOfWaterIsDryRock) {
  Parameters p = saturated(2.2e9);
  p.tolerance = 1e-4;
  const Arenisca skeleton(p, 2320.0);
  for (const double fluid : {1e-6, 1e-5, 1e-4, 1e-3}) {
    Sym3 stress{};
    Arenisca::History dry{};
    WetArenisca::History h;
    h.porosity = WetArenisca(p, 2320.0).initial_history().porosity;
    for (const Sym3& strain : path(50)) {
      h.gas = h.porosity - fluid;
      h.plastic_volume_strain = dry.plastic_volume_strain;
      h.equivalent_plastic_strain = dry.equivalent_plastic_strain;
      for (const double way : {1.0, -1.0}) expect_dry_step(p, way * strain, stress, h);
      if (HasFatalFailure() || HasNonfatalFailure()) return;
      const double x = trace(stress);
      Increment increment;
      increment.strain = strain;
      ASSERT_FALSE(skeleton.update(increment, stress, dry).failed());
      const double solid = 1.0 - h.porosity, matrix = p.B0 + p.B1;
      const double load = (x - trace(stress)) / (3.0 * matrix * solid);
      h.porosity = 1.0 - solid * std::exp(-load - trace(strain));
    }
  }
}

/// Water that is pressed out of rubble's gas bears the load as it would in rock: from the state of
/// the run back to full pores, against the dry law with the pressure as an unknown.
TEST(WetArenisca, RubbleThatIsPressedFillsAtItsOwnVolume) {
  Parameters p = bounded_berea();
  p.tolerance = 1e-4;
  const WetArenisca model(p, 2320.0);
  const Arenisca skeleton(p, 2320.0);
  const Rubble r = rubble_of_a_run();
  Sym3 stress = r.stress, wet = r.stress;
  WetArenisca::History h = r.h, after = r.h;
  // Of grains and water alone, without a stress.
  const double least = 1.0 - r.h.gas;
  constexpr int steps = 4000;
  Increment increment;
  increment.strain = isotropic(std::log(0.98 * least) / (3.0 * steps));
  for (int i = 0; i < steps; ++i) {
    step_by_halving(model, skeleton, increment.strain, stress, h);
    ASSERT_FALSE(model.update(increment, wet, after).failed()) << i;
  }
  EXPECT_GT(h.pore_pressure, 1e6);
  EXPECT_NEAR(after.pore_pressure, h.pore_pressure, 1e-3 * h.pore_pressure);
  EXPECT_LE(norm(wet - stress), 1e-3 * norm(stress));
}

}  // namespace
}  // namespace barreno::test
