// SPDX-License-Identifier: BSD-3-Clause
/// Voids of a metal: they close, the metal loads, spalls, opens and closes again.

#include "barreno/models/metals.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace barreno::test {
namespace {

using Porous = Expanded<JohnsonCook>;
constexpr double density = Sample<JohnsonCook>::density;  // kg/m3
constexpr double step_time = 1e-8;                        // s
constexpr double spall_stress = 1.2e9;                    // Pa

JohnsonCook::Parameters spalling_copper() {
  JohnsonCook::Parameters p = Sample<Porous>::parameters();
  p.spall_stress = spall_stress;
  return p;
}
JohnsonCook::Parameters strengthless_copper() {
  JohnsonCook::Parameters p = Sample<Porous>::parameters();
  p.a = 0.0;
  p.b = 0.0;
  return p;
}

Point<Porous> porous_point(const Porous& model, double expansion) {
  Point<Porous> point(model);
  const auto start = model.expanded_state(expansion);
  point.history = start.history;
  point.volume_ratio = start.volume_ratio;
  return point;
}

/// Compression along one axis with shear.
Sym3 squeeze(double strain) {
  return {0.0, strain, 0.0, 0.3 * strain, 0.0, 0.0};
}
double pressure(const Sym3& stress) {
  return -trace(stress) / 3.0;
}

TEST(ExpansionStrain, StartsAtRestWithTheMeanDensity) {
  const Porous model(spalling_copper(), density);
  const auto start = model.expanded_state(1.25);
  EXPECT_TRUE(start.possible);
  EXPECT_EQ(start.volume_ratio, 1.25);
  EXPECT_EQ(start.history.expansion_strain, std::log(1.25));
  EXPECT_EQ(largest_component(start.stress), 0.0);
  EXPECT_FALSE(model.expanded_state(0.9).possible);
}

TEST(ExpansionStrain, VoidsCloseAtNoStressAndWithoutPlasticWork) {
  const Porous model(spalling_copper(), density);
  Point<Porous> point = porous_point(model, 1.25);
  for (int i = 0; i < 22; ++i) {
    ASSERT_FALSE(point.apply(squeeze(-0.01), step_time).failed());
    EXPECT_EQ(largest_component(point.stress), 0.0);
    EXPECT_EQ(point.history.plastic_strain, 0.0);
    EXPECT_EQ(point.last.plastic_work, 0.0);
    EXPECT_EQ(point.last.elastic_work, 0.0);
    EXPECT_EQ(point.history.internal_energy, 0.0);
    EXPECT_NEAR(point.history.expansion_strain, std::log(point.volume_ratio), 1e-12);
    // With the mean density the sound speed is that of the solid.
    const double square = point.last.longitudinal_modulus / (density / point.volume_ratio);
    const double solid = model.Porous::Solid::longitudinal_modulus(Sym3{}, point.history, 1.0);
    EXPECT_NEAR(square / (solid / density), 1.0, 1e-12);
  }
  ASSERT_GT(point.history.expansion_strain, 0.0);
  ASSERT_FALSE(point.apply(squeeze(-0.01), step_time).failed());
  EXPECT_EQ(point.history.expansion_strain, 0.0);
  EXPECT_GT(pressure(point.stress), 0.0);
  EXPECT_GT(point.history.plastic_strain, 0.0);
}

/// Of the step in which the voids close the metal takes what is left of it, and then every step.
TEST(ExpansionStrain, ClosedVoidsLeaveTheRestOfAStepToTheMetal) {
  const Porous model(spalling_copper(), density);
  const JohnsonCook metal(Sample<JohnsonCook>::parameters(), density);
  Point<Porous> point = porous_point(model, std::exp(0.015));
  Point<JohnsonCook> solid(metal);
  ASSERT_FALSE(point.apply(squeeze(-0.02), step_time).failed());
  ASSERT_FALSE(solid.apply(squeeze(-0.005), 0.25 * step_time).failed());
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(pressure(point.stress) / pressure(solid.stress), 1.0, 1e-12);
    EXPECT_NEAR(point.stress.xy / solid.stress.xy, 1.0, 1e-12);
    EXPECT_NEAR(point.history.plastic_strain / solid.history.plastic_strain, 1.0, 1e-12);
    EXPECT_NEAR(point.history.internal_energy / solid.history.internal_energy, 1.0, 1e-11);
    EXPECT_NEAR(point.last.plastic_work / solid.last.plastic_work, 1.0, 1e-11);
    ASSERT_FALSE(point.apply(squeeze(-0.004), step_time).failed());
    ASSERT_FALSE(solid.apply(squeeze(-0.004), step_time).failed());
  }
}

TEST(ExpansionStrain, ViscousWorkInVoidsHeatsTheMetal) {
  const Porous model(spalling_copper(), density);
  Point<Porous> point = porous_point(model, 1.25);
  constexpr double q = 3e8;  // Pa
  ASSERT_FALSE(point.apply(squeeze(-0.05), step_time, q).failed());
  const double heat = q * (1.25 - point.volume_ratio) / density;
  EXPECT_NEAR(point.history.internal_energy / heat, 1.0, 1e-12);
  const double warmer = point.history.temperature - 294.0;
  EXPECT_NEAR(warmer / (heat / Sample<JohnsonCook>::parameters().specific_heat), 1.0, 1e-10);
  EXPECT_EQ(largest_component(point.stress), 0.0);
}

/// A step that closes them heats the metal by all of its viscous work, too.
TEST(ExpansionStrain, NoViscousWorkIsLostInTheStepThatCloses) {
  const Porous model(strengthless_copper(), density);
  Point<Porous> point = porous_point(model, std::exp(0.015));
  constexpr double q = 1e9;  // Pa
  const double before = point.volume_ratio;
  ASSERT_FALSE(point.apply(squeeze(-0.02), step_time, q).failed());
  const double viscous = q * (before - point.volume_ratio);
  const double gained = density * point.history.internal_energy;
  EXPECT_NEAR((point.last.elastic_work + point.last.plastic_work + viscous) / gained, 1.0, 1e-12);
}

TEST(ExpansionStrain, SpallOpensVoidsThatMustCloseAgain) {
  const Porous model(spalling_copper(), density);
  Point<Porous> point(model);
  const Sym3 pull = isotropic(0.001);
  int steps = 0;
  while (point.history.damage < 1.0 && ++steps < 100)
    ASSERT_FALSE(point.apply(pull, step_time).failed());
  ASSERT_LT(steps, 100);
  EXPECT_EQ(largest_component(point.stress), 0.0);
  const double at_spall = point.history.expansion_strain;
  EXPECT_GT(at_spall, 0.5 * spall_stress / (density * 3940.0 * 3940.0));
  // What is left of the volume is the metal's at no pressure.
  const double eta = 1.0 - point.volume_ratio * std::exp(-at_spall);
  const double rest = model.equation_of_state().pressure(eta, point.history.internal_energy);
  EXPECT_NEAR(rest, 0.0, 1e-3);

  const double plastic = point.history.plastic_strain;
  for (int i = 0; i < 10; ++i) ASSERT_FALSE(point.apply(pull, step_time).failed());
  EXPECT_NEAR(point.history.expansion_strain, at_spall + 0.03, 1e-12);
  EXPECT_EQ(point.history.plastic_strain, plastic);
  const Sym3 push = isotropic(-0.001);
  while (point.history.expansion_strain > 0.0 && ++steps < 200) {
    EXPECT_EQ(largest_component(point.stress), 0.0);
    EXPECT_EQ(point.history.plastic_strain, plastic);
    ASSERT_FALSE(point.apply(push, step_time).failed());
  }
  ASSERT_FALSE(point.apply(push, step_time).failed());
  EXPECT_GT(pressure(point.stress), 1e8);
  // Broken metal bears no tension: it opens again.
  for (int i = 0; i < 5; ++i) ASSERT_FALSE(point.apply(pull, step_time).failed());
  EXPECT_EQ(largest_component(point.stress), 0.0);
  EXPECT_GT(point.history.expansion_strain, 0.0);
}

TEST(ExpansionStrain, BrokenMetalWithLargeVoidsHasNextToNoModulusAndTheSizeOfItsSolid) {
  const Porous model(spalling_copper(), density);
  Point<Porous> point(model);
  while (point.history.damage < 1.0)
    ASSERT_FALSE(point.apply(isotropic(0.001), step_time).failed());
  const double temperature = point.history.temperature;
  const auto modulus_of_mean = [&] { return point.last.longitudinal_modulus * point.volume_ratio; };
  const double stiff = modulus_of_mean();
  while (point.history.expansion_strain < 0.49)
    ASSERT_FALSE(point.apply(isotropic(0.002), step_time).failed());
  EXPECT_NEAR(modulus_of_mean() / stiff, 1.0, 0.02) << "it may close within a step";
  while (point.history.expansion_strain < 3.0)
    ASSERT_FALSE(point.apply(isotropic(0.002), step_time).failed());
  EXPECT_NEAR(modulus_of_mean() / stiff, 0.01, 2e-4);
  EXPECT_EQ(point.history.temperature, temperature) << "voids do not cool";
  const auto open = point.history;
  ASSERT_FALSE(point.apply({-0.01, 0.02, 0.0, 0.05, 0.0, 0.0}, step_time).failed());
  EXPECT_EQ(largest_component(point.stress), 0.0);
  EXPECT_EQ(point.history.plastic_strain, open.plastic_strain);
  EXPECT_EQ(point.history.internal_energy, open.internal_energy);
  EXPECT_EQ(point.history.temperature, temperature) << "nothing is sheared between voids";
  const auto solid = Porous::expanded_ratio<double>(point.volume_ratio, point.history);
  EXPECT_NEAR(solid, 1.0, 0.01);
  // Voids that are not those of breaking, of a porous body or a jet: as stiff as the solid.
  const auto porous = model.expanded_state(20.0);
  EXPECT_NEAR(Porous::expanded_ratio<double>(20.0, porous.history), 1.0, 1e-14);
  EXPECT_NEAR(20.0 * model.longitudinal_modulus(Sym3{}, porous.history, 20.0) / stiff, 1.0, 0.02);
}

/// Molten metal that is broken has no shear modulus left, unless a step may cool it below melting.
TEST(ExpansionStrain, BrokenMoltenMetalHasNoShearModulus) {
  const Porous model(spalling_copper(), density);
  const auto& p = model.parameters();
  auto history = model.initial_history();
  const auto modulus = [&] { return model.longitudinal_modulus(isotropic(-1e9), history, 0.99); };
  const double solid = modulus();
  history.temperature = 2.0 * p.melt_temperature;
  EXPECT_EQ(modulus(), solid) << "whole metal may be cooled and sheared";
  history.damage = 1.0;
  EXPECT_NEAR(modulus(), solid - 4.0 / 3.0 * p.shear_modulus, 1e-9 * solid);
  history.temperature = 1.1 * p.melt_temperature;
  EXPECT_EQ(modulus(), solid);
}

#if BARRENO_HAS_LANES
TEST(ExpansionStrain, OpenBrokenMetalDoesNotDependOnTheLanesBesideIt) {
  const Porous model(spalling_copper(), density);
  Point<Porous> broken(model);
  while (broken.history.expansion_strain < 0.3)
    ASSERT_FALSE(broken.apply(isotropic(0.001), step_time).failed());
  const Point<Porous> closing = porous_point(model, 1.001);
  const auto update_with = [&](const Point<Porous>& others) {
    IncrementOf<Sym3Of<Lanes>> increment{};
    Sym3Of<Lanes> stress{};
    Porous::HistoryOf<Lanes> history{};
    increment.dt = Lanes{} + step_time;
    increment.viscous_pressure = Lanes{} + 1e8;
    for (int i = 0; i < lane_count; ++i) {
      const Point<Porous>& point = i == 0 ? broken : others;
      const Increment one = point.increment(squeeze(-0.01), step_time);
      for (int c = 0; c < 6; ++c)
        reals_of<Lanes>(increment.strain)[c][i] = reals_of<double>(one.strain)[c];
      increment.volume_ratio_begin[i] = one.volume_ratio_begin;
      increment.volume_ratio_end[i] = one.volume_ratio_end;
      for (int c = 0; c < Porous::history_count; ++c)
        reals_of<Lanes>(history)[c][i] = reals_of<double>(point.history)[c];
    }
    const auto outcome = model.update_points(increment, stress, history);
    std::vector<double> first{outcome.longitudinal_modulus[0]};
    for (int c = 0; c < Porous::history_count; ++c) first.push_back(reals_of<Lanes>(history)[c][0]);
    for (int c = 0; c < 6; ++c) first.push_back(reals_of<Lanes>(stress)[c][0]);
    EXPECT_NE(outcome.sound[0], 0);
    return first;
  };
  EXPECT_EQ(update_with(broken), update_with(closing));
}
#endif

TEST(ExpansionStrain, WithoutVoidsTheUpdateIsTheMetals) {
  const Porous model(spalling_copper(), density);
  const JohnsonCook metal(spalling_copper(), density);
  Point<Porous> point(model);
  Point<JohnsonCook> solid(metal);
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double shorter = -2e-5;
    const Sym3 strain =
        1e-3 * Sym3{u(engine), u(engine), u(engine), u(engine), u(engine), u(engine)} +
        isotropic(shorter);
    const double q = 1e7 * std::fabs(u(engine));
    ASSERT_FALSE(point.apply(strain, step_time, q).failed());
    ASSERT_FALSE(solid.apply(strain, step_time, q).failed());
    ASSERT_LT(solid.history.damage, 1.0);
    const double most = largest_component(solid.stress);
    ASSERT_LE(largest_component(point.stress - solid.stress), 1e-11 * most) << i;
    ASSERT_DOUBLE_EQ(point.last.longitudinal_modulus, solid.last.longitudinal_modulus);
    // From the same state again: compilers may round the two codes in other places.
    point.stress = solid.stress;
    static_cast<JohnsonCook::History&>(point.history) = solid.history;
  }
  EXPECT_EQ(point.history.expansion_strain, 0.0);
}

/// A steady shock from rest takes a point along its Rayleigh line, p + q = rho_s U^2 x / (alpha - 1
/// + eta)^2 at the compression x of the whole. Its end is the porous Hugoniot:
/// p = a(eta) / (1 - Gamma0 (alpha - 1 + eta) / 2), with the heat U^2 / 2.
TEST(ExpansionStrain, AShockEndsOnThePorousHugoniot) {
  const Porous model(strengthless_copper(), density);
  struct End {
    double expansion, speed, pressure;
  };
  for (const End& end :
       {End{1.25, 200.0, 1.3882e9},
        {1.5, 200.0, 0.71083e9},
        {1.25, 1000.0, 25.697e9},
        {1.5, 1000.0, 16.306e9},
        {1.9, 1000.0, 9.857e9}}) {
    const double energy = 0.5 * end.speed * end.speed;
    const double compression = 2.0 * density * energy / end.pressure;  // alpha - 1 + eta
    const double slope = end.pressure / compression;
    Point<Porous> point = porous_point(model, end.expansion);
    constexpr int steps = 20000;
    const double step = compression / steps;
    for (int i = 0; i < steps; ++i) {
      const double ratio = end.expansion - (i + 1) * step;
      const double q = slope * (i + 0.5) * step - pressure(point.stress);
      ASSERT_FALSE(point
                       .apply({0.0, std::log(ratio / point.volume_ratio), 0, 0, 0, 0}, step_time, q)
                       .failed());
    }
    EXPECT_NEAR(pressure(point.stress) / end.pressure, 1.0, 2e-3) << end.expansion;
    EXPECT_NEAR(point.history.internal_energy / energy, 1.0, 1e-3) << end.expansion;
  }
}

TEST(ExpansionStrain, AFailedUpdateLeavesThePointAsItWas) {
  const Porous model(spalling_copper(), density);
  Point<Porous> point = porous_point(model, 1.1);
  const auto history = point.history;
  EXPECT_EQ(point.apply(squeeze(NAN), step_time).status, Status::bad_input);
  EXPECT_EQ(point.apply(squeeze(-0.01), -step_time).status, Status::bad_input);
  EXPECT_EQ(point.apply(squeeze(-2.0), step_time).status, Status::bad_input);
  EXPECT_EQ(std::memcmp(&history, &point.history, sizeof history), 0);
  EXPECT_EQ(largest_component(point.stress), 0.0);
  point.history.expansion_strain = -0.1;
  EXPECT_EQ(point.apply(squeeze(-0.01), step_time).status, Status::bad_input);
}

#if BARRENO_HAS_LANES
/// Lanes whose voids are open, close, or are not there, and single points.
TEST(ExpansionStrain, LanesGiveWhatSinglePointsGive) {
  const Porous model(spalling_copper(), density);
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Point<Porous>> points;
    IncrementOf<Sym3Of<Lanes>> increment{};
    Sym3Of<Lanes> stress{};
    Porous::HistoryOf<Lanes> history{};
    increment.dt = Lanes{} + step_time;
    for (int i = 0; i < lane_count; ++i) {
      Point<Porous> point = porous_point(model, 1.0 + 0.01 * std::fmax(0.0, u(engine)));
      Increment one = point.increment(squeeze(0.02 * u(engine)), step_time);
      one.viscous_pressure = 1e8 * std::fabs(u(engine));
      for (int c = 0; c < 6; ++c)
        reals_of<Lanes>(increment.strain)[c][i] = reals_of<double>(one.strain)[c];
      increment.volume_ratio_begin[i] = one.volume_ratio_begin;
      increment.volume_ratio_end[i] = one.volume_ratio_end;
      increment.viscous_pressure[i] = one.viscous_pressure;
      for (int c = 0; c < Porous::history_count; ++c)
        reals_of<Lanes>(history)[c][i] = reals_of<double>(point.history)[c];
      point.last = model.update(one, point.stress, point.history);
      points.push_back(point);
    }
    const auto outcome = model.update_points(increment, stress, history);
    for (int i = 0; i < lane_count; ++i) {
      const Point<Porous>& point = points[static_cast<std::size_t>(i)];
      ASSERT_EQ(outcome.sound[i] != 0, !point.last.failed());
      EXPECT_NEAR(history.expansion_strain[i], point.history.expansion_strain, 1e-14);
      EXPECT_NEAR(stress.yy[i], point.stress.yy, 1e-11 * std::fabs(point.stress.yy) + 1e-3);
      EXPECT_NEAR(
          history.internal_energy[i],
          point.history.internal_energy,
          1e-10 * std::fabs(point.history.internal_energy) + 1e-9
      );
      const double plastic = point.history.plastic_strain;
      EXPECT_NEAR(history.plastic_strain[i], plastic, 1e-11 * plastic);
      EXPECT_NEAR(outcome.longitudinal_modulus[i] / point.last.longitudinal_modulus, 1.0, 1e-12);
      if (point.history.expansion_strain > 0.0) {
        EXPECT_EQ(stress.yy[i], 0.0);
      }
    }
  }
}
#endif

}  // namespace
}  // namespace barreno::test
