// SPDX-License-Identifier: BSD-3-Clause
/// Rate dependence together with damage and heat: limits, relaxation, and what is dissipated
/// (arenisca/points_rate.hpp, docs/method.md 20).
#include "arenisca_points.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

constexpr double density = 2130.0;

/// A rate dependence that no step sees the end of, or the beginning.
constexpr double instant = 1e-30, never = 1e30;

Parameters with_rate(Parameters p, double T1, double T2 = 0.0) {
  p.T1_rate_dependence = T1;
  p.T2_rate_dependence = T2;
  return p;
}
Parameters without_heat(Parameters p) {
  p.specific_heat = p.grueneisen = p.grain_density = p.melting_temperature = 0.0;
  p.initial_temperature = 293.0;
  return p;
}
/// With elastic moduli that do not depend on the state.
Parameters linear(Parameters p) {
  p.B0 += p.B1;
  p.B1 = p.B2 = p.G1 = p.G2 = 0.0;
  return p;
}
Parameters breaking_rock() {
  return linear(Sample<DamagedArenisca>::parameters());
}
Parameters hot_rock() {
  return linear(Sample<HeatedArenisca>::parameters());
}

/// Strains of a path that shears, opens, crushes and turns back.
std::vector<Sym3> random_strains(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] {
    return Sym3{
        normal(random), normal(random), normal(random), normal(random), normal(random), 0.0};
  };
  const Sym3 direction = draw();
  std::vector<Sym3> strains;
  for (int i = 0; i < count; ++i) {
    const double reversal = i % 40 < 25 ? 1.0 : -1.0;
    strains.push_back(
        2e-4 * (reversal * direction + 0.3 * draw()) - isotropic(i % 60 < 30 ? 2e-4 : -1e-4)
    );
  }
  return strains;
}

/// tau -> 0: the form without rate, to round-off, with its damage and its heat.
template <class Rated, class Plain>
void expect_slow_limit(const Parameters& p, double bound = 1e-11) {
  const Rated rated(with_rate(p, instant), density);
  const Plain plain(p, density);
  double damage = 0.0, warmest = 0.0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    Point<Rated> a(rated);
    Point<Plain> b(plain);
    double peak = 1e6;
    for (const Sym3& strain : random_strains(seed, 240)) {
      ASSERT_FALSE(a.apply(strain, 1e-6, 1e6).failed());
      ASSERT_FALSE(b.apply(strain, 1e-6, 1e6).failed());
      peak = std::max(peak, norm(b.stress));
      ASSERT_LE(norm(a.stress - b.stress), bound * peak) << seed;
      ASSERT_NEAR(a.history.damage, b.history.damage, bound) << seed;
      ASSERT_NEAR(a.last.plastic_work, b.last.plastic_work, bound * peak * norm(strain));
      ASSERT_NEAR(a.last.elastic_work, b.last.elastic_work, bound * peak * norm(strain));
      if constexpr (Plain::Law::heated) {
        ASSERT_NEAR(a.history.temperature / b.history.temperature, 1.0, bound);
        warmest = std::max(warmest, b.history.temperature);
      }
    }
    damage = std::max(damage, b.history.damage);
  }
  EXPECT_GT(damage, 0.5);
  if constexpr (Plain::Law::heated) {
    EXPECT_GT(warmest, 305.0);
  }
}
TEST(RatedDamage, SlowIsTheFormWithoutRate) {
  const Parameters dry = Sample<HeatedArenisca>::parameters();
  expect_slow_limit<RatedHeatedArenisca, HeatedArenisca>(dry);
  expect_slow_limit<RatedHeatedArenisca, DamagedArenisca>(without_heat(dry));
  // Of grains that stiffen the pressure is solved again under the overstress, to 1e-13 of the
  // volume: 1e-3 Pa.
  Parameters stiffening = Sample<HeatedWetArenisca>::parameters(), bounded = stiffening;
  stiffening.tension_cutoff = 0.0;
  bounded.grain_stiffening = bounded.fluid_stiffening = 0.0;
  bounded.transition_strain = bounded.transition_start = bounded.transition_end = 0.0;
  for (const Parameters& wet : {stiffening, bounded}) {
    SCOPED_TRACE(wet.tension_cutoff > 0.0 ? "bounded" : "stiffening");
    const double bound = wet.grain_stiffening > 0.0 ? 1e-10 : 1e-11;
    expect_slow_limit<RatedHeatedWetArenisca, HeatedWetArenisca>(wet, bound);
    expect_slow_limit<RatedHeatedWetArenisca, DamagedWetArenisca>(without_heat(wet), bound);
  }
}

/// tau -> infinity: elastic, without damage and without heat of plastic work.
TEST(RatedDamage, FastIsElastic) {
  const Parameters p = with_rate(hot_rock(), never);
  const RatedHeatedArenisca model(p, density);
  for (unsigned seed = 0; seed < 12; ++seed) {
    Point<RatedHeatedArenisca> point(model);
    Sym3 strain{};
    double quasi_static = 0.0;
    for (const Sym3& by : random_strains(seed, 240)) {
      ASSERT_FALSE(point.apply(by, 1e-6).failed());
      strain = strain + by;
      const Sym3 hooke = (2.0 * p.G0) * deviator(strain) + isotropic(p.B0 * trace(strain));
      ASSERT_LE(norm(point.stress - hooke), 1e-9 * std::max(norm(hooke), 1e8)) << seed;
      ASSERT_LE(std::abs(point.last.plastic_work), 1e-9 * std::max(norm(hooke), 1e8) * norm(by));
      quasi_static = point.history.equivalent_plastic_strain;
    }
    EXPECT_GT(quasi_static, 1e-3) << "it would have flowed";
    EXPECT_LE(point.history.damage, 1e-12);
    EXPECT_NEAR(point.history.temperature, p.initial_temperature, 1e-9);
  }
}

/// Rated rock that is damaged as it flows, at constant strain: the overstress decays with tau.
TEST(RatedDamage, OverstressDecaysAtConstantStrain) {
  constexpr double tau = 1e-6;
  const RatedHeatedArenisca model(with_rate(breaking_rock(), tau), density);
  for (const int parts : {1, 7, 50}) {
    Point<RatedHeatedArenisca> point(model);
    for (int i = 0; i < 20; ++i)
      ASSERT_FALSE(point.apply({-2e-4, 1e-4, 0.0, 4e-4, 0.0, 0.0}, 1e-7).failed());
    const double first = point.history.overstress_xy, damage = point.history.damage;
    ASSERT_GT(std::abs(first), 1e6);
    const Sym3 end = point.stress - arenisca::overstress_of<double>(point.history);
    for (int i = 0; i < parts; ++i) ASSERT_FALSE(point.apply({}, 2.0 * tau / parts).failed());
    EXPECT_NEAR(point.history.overstress_xy / first, std::exp(-2.0), 0.02) << parts;
    EXPECT_GT(point.history.damage, damage) << "what relaxes is plastic strain";
    // The quasi-static answer stands still but where its own surface comes down with the damage.
    const Sym3 now = point.stress - arenisca::overstress_of<double>(point.history);
    EXPECT_LE(norm(now - end), 0.2 * norm(end)) << parts;
  }
}

/// Damage of overstress that relaxes is that of the strain it becomes, by (18.2) written anew.
TEST(RatedDamage, RelaxationDamagesByItsStrain) {
  constexpr double tau = 1e-6;
  Parameters p = breaking_rock();
  p.damage_pressure = 0.0;
  p.p3_crush_curve = p.p0_crush_curve = p.p1_crush_curve = 0.0;
  const RatedHeatedArenisca model(with_rate(p, tau), density);
  Point<RatedHeatedArenisca> point(model);
  point.history.overstress_xx = 3e6;
  point.history.overstress_yy = -1e6;
  point.history.overstress_xy = 4e6;
  const Sym3 over = arenisca::overstress_of<double>(point.history);
  point.stress = over + isotropic(-50e6);
  ASSERT_FALSE(point.apply({}, 0.7 * tau).failed());
  const double gone = 1.0 - std::exp(-0.7);
  const Sym3 shear = (gone / (2.0 * p.G0)) * deviator(over);
  const double opened = gone * trace(over) / (3.0 * p.B0);
  const double strain = std::sqrt(2.0 / 3.0 * contract(shear, shear)) + std::max(opened, 0.0) / 3.0;
  EXPECT_NEAR(point.history.damage / (strain / p.fracture_strain), 1.0, 1e-12);
  EXPECT_NEAR(
      norm(arenisca::overstress_of<double>(point.history)) / norm(over), std::exp(-0.7), 1e-12
  );
  // Dissipated is the mean stress times that strain.
  const Sym3 flow = shear + isotropic(opened / 3.0);
  const Sym3 mean = isotropic(-50e6) + 0.5 * (1.0 + std::exp(-0.7)) * over;
  EXPECT_NEAR(point.last.plastic_work / contract(mean, flow), 1.0, 1e-12);
}

/// Damage that has grown when the overstress is gone is that of the whole plastic strain: fast and
/// slow loading to one strain end alike in rock without pores that hardly softens on the way.
TEST(RatedDamage, DamageFollowsTheViscoplasticStrain) {
  constexpr double tau = 1e-6;
  Parameters p = breaking_rock();
  p.damage_pressure = 0.0;
  p.p3_crush_curve = p.p0_crush_curve = p.p1_crush_curve = 0.0;
  p.fracture_strain = 10.0;  // it stays below a hundredth
  const RatedHeatedArenisca rated(with_rate(p, tau), density);
  const DamagedArenisca plain(p, density);
  Point<RatedHeatedArenisca> fast(rated);
  Point<DamagedArenisca> slow(plain);
  const int steps = 200;
  double least = 1.0;  // of the damage under way over that without rate
  for (int i = 0; i < steps; ++i) {
    const Sym3 strain = (0.02 / steps) * Sym3{-0.5, 0.5, 0.0, 1.0, 0.0, 0.0};
    ASSERT_FALSE(fast.apply(strain, 0.2 * tau / steps).failed());
    ASSERT_FALSE(slow.apply(strain, 1e-6).failed());
    if (slow.history.damage > 1e-4)
      least = std::min(least, fast.history.damage / slow.history.damage);
  }
  EXPECT_LT(least, 0.15) << "a fifth of tau";
  for (int i = 0; i < 40; ++i) ASSERT_FALSE(fast.apply({}, tau).failed());
  EXPECT_NEAR(fast.history.damage / slow.history.damage, 1.0, 0.01);
}

/// One path in steps of n parts: at least first order in the step, stress, damage and temperature.
TEST(RatedDamage, ConvergesWithTheStep) {
  Parameters p = with_rate(Sample<HeatedArenisca>::parameters(), 3e-7);
  p.tolerance = 1e-7;
  const RatedHeatedArenisca model(p, density);
  struct End {
    Sym3 stress;
    double damage, temperature;
  };
  const auto end = [&](int n) {
    Point<RatedHeatedArenisca> point(model);
    const double whole = 1e-6;
    const auto at = [](double t) {
      return Sym3{-0.012 * t, 0.004 * t * t, 0.0, 0.006 * t * t, 0.0, -0.004 * std::sin(t)};
    };
    for (int i = 0; i < n; ++i)
      EXPECT_FALSE(point.apply(at((i + 1.0) / n) - at(double(i) / n), whole / n).failed());
    return End{point.stress, point.history.damage, point.history.temperature};
  };
  const End best = end(8192);
  EXPECT_GT(best.damage, 0.05);
  EXPECT_LT(best.damage, 0.95);
  std::vector<double> of_stress, of_damage, of_heat;
  for (const int n : {32, 128, 512}) {
    const End e = end(n);
    of_stress.push_back(norm(e.stress - best.stress) / norm(best.stress));
    of_damage.push_back(std::abs(e.damage / best.damage - 1.0));
    of_heat.push_back(std::abs(e.temperature - best.temperature) / (best.temperature - 300.0));
  }
  for (const auto& errors : {of_stress, of_damage, of_heat}) {
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 4.0, 0.9)
        << errors[0] << ' ' << errors[1] << ' ' << errors[2];
    EXPECT_LT(errors[2], 0.01);
  }
}

/// What is dissipated is not negative where overstress is not left behind by a reversal: in
/// drives of one direction, whatever the rate.
TEST(RatedDamage, DissipatesInDrivesOfOneDirection) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int flows = 0;
  for (int drive = 0; drive < 200; ++drive) {
    const double T1 = std::pow(10.0, -9.0 + drive % 5);
    const RatedHeatedArenisca model(with_rate(Sample<HeatedArenisca>::parameters(), T1), density);
    Point<RatedHeatedArenisca> point(model);
    const Sym3 by = 2e-4 * Sym3{
                               normal(random),
                               normal(random),
                               normal(random),
                               normal(random),
                               normal(random),
                               normal(random)};
    double scale = 0.0;
    for (int i = 0; i < 200; ++i) {
      ASSERT_FALSE(point.apply(by, 1e-7).failed());
      scale = std::max(scale, norm(point.stress) * norm(by));
      ASSERT_GE(point.last.plastic_work, -1e-9 * scale) << drive << ' ' << i << " T1 " << T1;
      flows += point.last.plastic_work > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(flows, 20000);
}

/// Works add up to the work done on the rock, and heat is what plastic work leaves.
TEST(RatedDamage, KeepsTheEnergy) {
  const double heat_capacity = Sample<HeatedArenisca>::parameters().specific_heat;
  const RatedHeatedArenisca model(with_rate(Sample<HeatedArenisca>::parameters(), 2e-6), density);
  for (unsigned seed = 0; seed < 6; ++seed) {
    Point<RatedHeatedArenisca> point(model);
    double works = 0.0, done = 0.0, scale = 0.0, heat = 0.0;
    for (const Sym3& strain : random_strains(seed, 240)) {
      const Sym3 before = point.stress;
      const double swelling = point.history.thermal_expansion, ratio = point.volume_ratio;
      ASSERT_FALSE(point.apply(strain, 1e-6).failed());
      const double mean_ratio = 0.5 * (ratio + point.volume_ratio);
      const Sym3 mean = 0.5 * (before + point.stress);
      done += mean_ratio * contract(mean, strain);
      works += point.last.elastic_work + point.last.plastic_work;
      heat += point.last.plastic_work + mean_ratio * trace(mean) / 3.0 * swelling;
      scale += std::abs(mean_ratio * contract(mean, strain));
    }
    EXPECT_NEAR(works, done, 1e-3 * scale) << seed;
    EXPECT_NEAR(density * heat_capacity * (point.history.temperature - 300.0), heat, 1e-9 * scale);
  }
}

/// A card without heat keeps its temperature, and takes none of a host.
TEST(RatedDamage, WithoutHeatTheTemperatureStays) {
  const RatedHeatedArenisca model(with_rate(breaking_rock(), 1e-6), density);
  Point<RatedHeatedArenisca> point(model);
  for (const Sym3& strain : random_strains(3, 240))
    ASSERT_FALSE(point.apply(strain, 1e-6, 1e7).failed());
  model.add_heat(1e5, point.stress, point.history);
  EXPECT_EQ(point.history.temperature, 293.0);
  EXPECT_EQ(point.history.thermal_expansion, 0.0);
  EXPECT_GT(point.history.damage, 0.0);
}

}  // namespace
}  // namespace barreno::test
