// SPDX-License-Identifier: BSD-3-Clause
/// Rock that heats: thermal pressure, thermal softening, and where its energy goes
/// (parts/heat.hpp).
#include "arenisca_points.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;
using History = HeatedArenisca::History;

constexpr double density = 2120.0, heat_capacity = 1000.0, gamma = 0.7, grain_density = 2650.0;

/// As materials/cards/berea_sandstone_heat.xml, without damage.
Parameters hot_rock() {
  Parameters p = berea();
  p.PEAKI1 = 5.78e6;
  p.FSLOPE = 0.627;
  p.dilatancy_limit = 0.05;
  p.dilatancy_pressure = 60e6;
  p.strength_limit = 1e9;
  p.specific_heat = heat_capacity;
  p.grueneisen = gamma;
  p.grain_density = grain_density;
  p.melting_temperature = 2500.0;
  return p;
}
/// Without pores, and with moduli that do not depend on the state.
Parameters solid_rock() {
  Parameters p = hot_rock();
  p.p0_crush_curve = p.p1_crush_curve = p.p3_crush_curve = 0.0;
  p.B0 += p.B1;
  p.B1 = p.B2 = p.G1 = p.G2 = 0.0;
  return p;
}

/// A point, and what it took.
struct HotPoint {
  HeatedArenisca model;
  Sym3 stress{};
  History history;
  double ratio = 1.0;                                  ///< V/V_ref
  double elastic = 0.0, plastic = 0.0, viscous = 0.0;  ///< works per reference volume
  double done = 0.0;                                   ///< by stress and viscosity on it
  double expanded = 0.0;                               ///< by the stress on expanding grains

  explicit HotPoint(const Parameters& p) : model(p, density), history(model.initial_history()) {}

  void strain(const Sym3& by, double viscosity = 0.0) {
    Increment i{};
    i.strain = by;
    i.dt = 1e-9;
    i.volume_ratio_begin = ratio;
    i.volume_ratio_end = ratio * std::exp(trace(by));
    i.viscous_pressure = viscosity;
    const Sym3 before = stress;
    const double swelling = history.thermal_expansion;
    const Outcome o = model.update(i, stress, history);
    ASSERT_FALSE(o.failed());
    const double mean_ratio = 0.5 * (i.volume_ratio_begin + i.volume_ratio_end);
    const double heated = viscosity * (i.volume_ratio_begin - i.volume_ratio_end);
    elastic += o.elastic_work;
    plastic += o.plastic_work;
    viscous += heated;
    done += mean_ratio * 0.5 * contract(before + stress, by) + heated;
    expanded += mean_ratio * trace(before + stress) / 6.0 * swelling;
    ratio = i.volume_ratio_end;
  }
  double pressure() const { return -trace(stress) / 3.0; }
  double heat() const { return density * heat_capacity * (history.temperature - 293.0); }
};

/// Heat at fixed volume in solid rock: dp = Gamma rho_s dq, that of Mie and Grueneisen.
TEST(Heat, PressesWhereThereAreNoPores) {
  for (const double stiffening : {0.0, 5.0}) {
    Parameters p = solid_rock();
    p.grain_stiffening = stiffening;
    HotPoint point(p);
    const double given = 1e5;  // J/kg
    const int parts = 1000;
    for (int i = 0; i < parts; ++i) {
      point.model.add_heat(given / parts, point.stress, point.history);
      point.strain({});
    }
    EXPECT_NEAR(point.history.temperature, 293.0 + given / heat_capacity, 1.0);
    // The work p de_T that it does on its own volume is taken from it.
    const double kept = point.heat() / density;
    EXPECT_NEAR(point.pressure() / (gamma * grain_density * kept), 1.0, 1e-2) << stiffening;
    EXPECT_NEAR(
        point.heat() + point.elastic - point.expanded, density * given, 1e-3 * density * given
    );
  }
}

/// Open pores take the expansion up: the pressure is K/K_s of it.
TEST(Heat, PressesLessWithPores) {
  HotPoint point(hot_rock());
  for (int i = 0; i < 20; ++i) point.strain(isotropic(-5e-5));
  const double before = point.pressure();
  const double bulk = point.model.drained_moduli(point.stress, point.history).bulk;
  point.model.add_heat(100.0, point.stress, point.history);
  point.strain({});
  const Parameters p = hot_rock();
  const double expected = gamma * grain_density * 100.0 * bulk / (p.B0 + p.B1);
  EXPECT_NEAR((point.pressure() - before) / expected, 1.0, 0.02);
}

/// Hot rock has the strength of cold rock times 1 - (T - T0)/(T_m - T0), and a thousandth beyond.
TEST(Heat, SoftensRock) {
  const auto strength = [](double temperature) {
    Parameters p = solid_rock();
    p.grueneisen = p.grain_density = p.BETA_nonassociativity = 0.0;
    p.specific_heat = 1e12;  // stays at this temperature
    HotPoint point(p);
    point.history.temperature = temperature;
    for (int i = 0; i < 100; ++i) point.strain(isotropic(-1e-4));
    for (int i = 0; i < 400; ++i) point.strain({1e-4, -1e-4, 0.0, 0.0, 0.0, 0.0});
    const Sym3 s = deviator(point.stress);
    const double q = std::sqrt(0.5 * contract(s, s));
    return q / point.model.rock().surface.limit(trace(point.stress));
  };
  for (const double way : {0.0, 0.25, 0.5, 0.9})
    EXPECT_NEAR(strength(293.0 + way * (2500.0 - 293.0)), 1.0 - way, 1e-6) << way;
  EXPECT_NEAR(strength(4000.0), 1e-3, 1e-6);
}

/// Works add up to what was done on the rock, and the heat is the plastic and viscous work less
/// that of its expansion.
TEST(Heat, KeepsTheEnergy) {
  HotPoint point(hot_rock());
  for (int i = 0; i < 800; ++i)
    point.strain({-1e-3, i % 50 < 10 ? 4e-4 : 0.0, 0.0, 0.0, 0.0, 0.0}, 1e7);
  for (int i = 0; i < 100; ++i) point.strain({2e-4, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_GT(point.history.temperature, 450.0);
  const double works = point.elastic + point.plastic + point.viscous;
  EXPECT_NEAR(works / point.done, 1.0, 1e-3);
  EXPECT_NEAR(point.heat() / (point.plastic + point.viscous + point.expanded), 1.0, 1e-12);
  EXPECT_LT(point.expanded, 0.0);
}

/// Relative volume at which a shock ends: strain by strain, with the viscosity that keeps the axial
/// stress on the straight line of a steady shock.
struct Shock {
  double volume, energy, stress, temperature;
};
Shock shock_at(double slope, double step) {
  HotPoint point(hot_rock());
  double line = 0.0, stress = 0.0;
  do {
    const double begin = slope * (1.0 - point.ratio),
                 middle = slope * (1.0 - point.ratio * std::exp(-0.5 * step));
    const double q = std::max(0.0, middle - std::max(stress, 0.0) - 0.5 * (begin - line));
    point.strain({-step, 0.0, 0.0, 0.0, 0.0, 0.0}, q);
    line = slope * (1.0 - point.ratio);
    stress = -point.stress.xx;
  } while (stress < line);
  return {point.ratio, point.done, stress, point.history.temperature};
}
/// Jump conditions: the energy behind a shock is half the stress times the volume that is lost.
TEST(Heat, MeetsTheJumpConditions) {
  const double slope = 40e9;
  const Shock rough = shock_at(slope, 1e-3), fine = shock_at(slope, 1e-4);
  EXPECT_NEAR(fine.energy / (0.5 * fine.stress * (1.0 - fine.volume)), 1.0, 5e-3);
  EXPECT_NEAR(rough.volume / fine.volume, 1.0, 5e-3);
  EXPECT_GT(fine.temperature, 700.0);
  // Heat expands: without it the same stress compresses more.
  HotPoint cold(hot_rock());
  while (-cold.stress.xx < fine.stress) cold.strain({-1e-3, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_LT(cold.ratio, fine.volume - 0.005);
}

/// The expansion comes a step late: half the step, half the error.
TEST(Heat, LagsByAStep) {
  const auto end = [](int steps) {
    HotPoint point(solid_rock());
    for (int i = 0; i < steps; ++i)
      point.strain({-0.1 / steps, 0.0, 0.0, 0.05 / steps, 0.0, 0.0}, 2e9);
    return point.pressure();
  };
  const double best = end(6400), coarse = std::abs(end(100) - best),
               fine = std::abs(end(400) - best);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 0.9);
  EXPECT_LT(coarse / best, 0.02);
}

/// Without heat that expands or softens, the stress is that of the damaged form, to the bits.
TEST(Heat, OffIsTheFormWithoutIt) {
  Parameters p = Sample<DamagedArenisca>::parameters(), inert = p;
  inert.specific_heat = 1000.0;
  const DamagedArenisca damaged(p, density);
  const HeatedArenisca heated(inert, density);
  Sym3 a{}, b{};
  auto h = damaged.initial_history();
  auto k = heated.initial_history();
  for (int i = 0; i < 500; ++i) {
    Increment increment{};
    const double wave = std::sin(0.1 * i);
    increment.strain = {-4e-4 + 6e-4 * wave, 3e-4 * wave, -1e-4, 2e-4, 0.0, 1e-4 * wave};
    increment.dt = 1e-9;
    ASSERT_FALSE(damaged.update(increment, a, h).failed());
    ASSERT_FALSE(heated.update(increment, b, k).failed());
    ASSERT_EQ(a.xx, b.xx) << i;
    ASSERT_EQ(a.xy, b.xy) << i;
    ASSERT_EQ(h.damage, k.damage) << i;
  }
  EXPECT_GT(k.temperature, 293.0);
}

/// Fluid that moves at fixed strain leaves the expansion for the next step.
TEST(Heat, WaitsWhileFluidMoves) {
  const HeatedWetArenisca model(Sample<HeatedWetArenisca>::parameters(), density);
  Sym3 stress{};
  auto h = model.initial_history();
  Increment increment{};
  increment.strain = isotropic(-0.005);
  increment.dt = 1e-9;
  ASSERT_FALSE(model.update(increment, stress, h).failed());
  h.thermal_expansion = 1e-4;
  ASSERT_FALSE(model.drain(-1e-4, stress, h).failed());
  EXPECT_GE(h.thermal_expansion, 1e-4);
  EXPECT_LT(h.thermal_expansion, 1.2e-4);
}

}  // namespace
}  // namespace barreno::test
