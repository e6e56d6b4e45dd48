// SPDX-License-Identifier: BSD-3-Clause
/// Liquid: Hugoniot, sound speed, and voids that open and close where the isentrope meets the
/// vapour pressure.

#include "barreno/find_card.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

namespace barreno::test {
namespace {

constexpr double density = 998.2;

/// Water with absolute pressures, so that the vapour pressure is positive.
Liquid::Parameters water() {
  Liquid::Parameters p;
  p.specific_heat = 4157.0;
  p.sound_speed = 1483.0;
  p.slope = 1.921;
  p.gamma = 0.28;
  p.vapour_pressure = 2339.0;
  p.initial_pressure = 101325.0;
  return p;
}

/// A point that follows given volumes.
struct LiquidPoint {
  const Liquid& model;
  Sym3 stress;
  Liquid::History history;
  double volume;
  double elastic_work = 0.0, heat = 0.0;  ///< sums over the steps, per reference volume
  double modulus = 0.0;

  LiquidPoint(const Liquid& m, double pressure) : model(m) {
    const auto start = m.initial_state(pressure);
    EXPECT_TRUE(start.possible);
    stress = start.stress;
    history = start.history;
    volume = start.volume_ratio;
  }
  double pressure() const { return -trace(stress) / 3.0; }
  void go_to(double end, double viscosity = 0.0) {
    Increment increment{};
    increment.strain = isotropic(std::log(end / volume) / 3.0);
    increment.dt = 1e-9;
    increment.volume_ratio_begin = volume;
    increment.volume_ratio_end = end;
    increment.viscous_pressure = viscosity;
    const Outcome outcome = model.update(increment, stress, history);
    EXPECT_FALSE(outcome.failed());
    elastic_work += outcome.elastic_work;
    heat -= viscosity * (end - volume);
    modulus = outcome.longitudinal_modulus;
    volume = end;
  }
  void go_in_steps(double end, int steps) {
    const double begin = volume;
    for (int i = 1; i <= steps; ++i) go_to(begin + (end - begin) * i / steps);
  }
  /// Energy per reference volume, that of the void included.
  double energy() const {
    return history.internal_energy * density -
           model.parameters().vapour_pressure * history.void_volume;
  }
};

/// One step from rest has the mean pressure p / 2, and so the energy of the jump conditions.
TEST(Liquid, OneStepLeadsOntoTheHugoniot) {
  auto p = water();
  p.vapour_pressure = 0.0;
  const Liquid model(p, density);
  for (const double eta : {0.01, 0.1, 0.2, 0.3, 0.4}) {
    LiquidPoint point(model, 0.0);
    point.go_to(1.0 - eta);
    const double up = p.sound_speed * eta / (1.0 - p.slope * eta);  // eta = u_p / U_s
    const double jump = density * (p.sound_speed + p.slope * up) * up;
    EXPECT_NEAR(point.pressure() / jump, 1.0, 1e-12) << eta;
    EXPECT_NEAR(point.history.internal_energy / (0.5 * up * up), 1.0, 1e-12) << eta;
  }
}

/// Where the void opens, the isentrope through the start has the vapour pressure: initial_state
/// finds that volume by an integral of its own.
TEST(Liquid, VoidOpensAndClosesAtTheVolumeOfTheIsentrope) {
  for (const double vapour : {2339.0, 0.0, -2e6}) {
    auto p = water();
    p.vapour_pressure = vapour;
    const Liquid model(p, density);
    LiquidPoint point(model, 5e6);
    const double begin = point.volume;
    // Of tension there is no initial state: there the law is P = K eta + Gamma0 E, dE = P deta.
    const double bulk = density * p.sound_speed * p.sound_speed;
    const double opens = vapour >= 0.0 ? model.initial_state(vapour).volume_ratio
                                       : 1.0 - std::log1p(p.gamma * vapour / bulk) / p.gamma;
    point.go_in_steps(1.01, 1000);
    EXPECT_EQ(point.pressure(), vapour);
    EXPECT_NEAR(1.01 - point.history.void_volume, opens, 1e-9);
    const double temperature = point.history.temperature;
    point.go_in_steps(1.5, 100);
    EXPECT_EQ(point.history.temperature, temperature);
    EXPECT_EQ(point.pressure(), vapour);
    point.go_in_steps(opens + 1e-7, 100);
    EXPECT_EQ(point.pressure(), vapour);
    EXPECT_EQ(point.history.temperature, temperature);
    point.go_to(opens - 1e-7);
    EXPECT_EQ(point.history.void_volume, 0.0);
    EXPECT_NEAR((point.pressure() - vapour) / (bulk * 1e-7), 1.0, 0.05);
    point.go_in_steps(begin, 1000);
    EXPECT_NEAR(point.pressure() / 5e6, 1.0, 1e-6);
  }
}

/// What the work changes is the energy, step by step; a closed cycle leaves what the trapezoidal
/// rule errs, of second order.
TEST(Liquid, ClosedCycleGivesNoWork) {
  const Liquid model(water(), density);
  double before = 0.0;
  for (const int steps : {50, 100, 200}) {
    LiquidPoint point(model, 1e9);
    const double begin = point.volume, start = point.energy();
    double turnover = 0.0;
    for (const double end : {1.02, 0.8, 1.3, begin}) {
      const double work = point.elastic_work;
      point.go_in_steps(end, steps);
      turnover += std::fabs(point.elastic_work - work);
      EXPECT_NEAR((point.energy() - start - point.elastic_work) / turnover, 0.0, 1e-13);
    }
    const double gain = point.elastic_work / turnover;
    EXPECT_LT(std::fabs(gain), 0.2 / steps);
    if (before != 0.0) {
      EXPECT_LT(std::fabs(gain), 0.3 * std::fabs(before));
    }
    before = gain;
  }
}

TEST(Liquid, ModulusIsTheSlopeOfTheIsentrope) {
  const Liquid model(water(), density);
  for (const double volume : {0.6, 0.8, 0.95, 1.0}) {
    LiquidPoint point(model, 101325.0);
    point.go_to(volume - 1e-6 < 1.0 ? volume : volume - 1e-3);
    const double middle = point.volume, h = 1e-5;
    LiquidPoint low = point, high = point;
    low.go_to(middle - h);
    high.go_to(middle + h);
    if (high.history.void_volume > 0.0) continue;
    const double slope = (low.pressure() - high.pressure()) / (2.0 * h) * middle;
    EXPECT_NEAR(point.modulus / slope, 1.0, 1e-5) << volume;
  }
}

/// c^2 = modulus / mean density is that of the liquid while a step may close the void, and next to
/// nothing beyond.
TEST(Liquid, WideVoidHasNextToNoModulus) {
  const Liquid model(water(), density);
  LiquidPoint point(model, 101325.0);
  const double bulk = density * 1483.0 * 1483.0;
  for (const double volume : {1.001, 1.2, 1.6, 1.7, 10.0, 1e6}) {
    point.go_to(volume);
    const double share = volume < std::exp(0.5) ? 1.0 : 0.01;
    EXPECT_NEAR(point.modulus * volume / bulk, share, 1e-3 * share) << volume;
    EXPECT_NEAR(Liquid::expanded_ratio(volume, point.history), 1.0, 1e-4);
    const double again = model.longitudinal_modulus(point.stress, point.history, volume);
    EXPECT_NEAR(again / point.modulus, 1.0, 1e-15 * (1.0 + volume)) << volume;
  }
}

/// All work of the artificial viscosity heats the liquid, in voids too, and its volume grows.
TEST(Liquid, ViscosityHeatsInVoids) {
  const Liquid model(water(), density);
  LiquidPoint point(model, 101325.0);
  point.go_to(1.2);
  const double cold = point.history.temperature, liquid = 1.2 - point.history.void_volume;
  const double energy = point.energy(), work = point.elastic_work;
  point.go_to(1.1, 1e8);
  const double growth = 1.1 - point.history.void_volume - liquid;
  EXPECT_NEAR(growth / (0.28 * point.heat / (density * 1483.0 * 1483.0)), 1.0, 1e-3);
  // Growing at constant pressure cools by T Gamma0 dV: the heat capacity is that at constant
  // pressure.
  const double warmer = point.heat / (density * 4157.0) - cold * 0.28 * growth;
  EXPECT_NEAR((point.history.temperature - cold) / warmer, 1.0, 1e-3);
  EXPECT_NEAR((point.energy() - energy) / (point.heat + point.elastic_work - work), 1.0, 1e-13);
}

/// The gain that the update found changes nothing; another one is heat.
TEST(Liquid, CorrectedEnergyKnowsTheVoid) {
  const Liquid model(water(), density);
  LiquidPoint point(model, 101325.0);
  const auto before = point.history;
  point.go_to(1.3);
  auto history = point.history;
  model.correct_energy(before, point.elastic_work / density, history);
  EXPECT_NEAR(history.internal_energy, point.history.internal_energy, 1e-12);
  EXPECT_NEAR(history.temperature, point.history.temperature, 1e-12);
  model.correct_energy(before, point.elastic_work / density + 10.0, history);
  EXPECT_NEAR(history.internal_energy, point.history.internal_energy + 10.0, 1e-12);
  EXPECT_NEAR(history.temperature, point.history.temperature + 10.0 / 4157.0, 1e-12);
}

#if BARRENO_HAS_LANES
/// Points in one vector, open and closed, go each their own way.
TEST(Liquid, LanesAreThePointsAlone) {
  const Liquid model(water(), density);
  Sym3Of<Lanes> stress{};
  Liquid::HistoryOf<Lanes> history{};
  Lanes volume{};
  std::vector<LiquidPoint> points;
  for (int i = 0; i < lane_count; ++i) {
    points.emplace_back(model, 101325.0 * (1 + i));
    stress.xx[i] = points.back().stress.xx;
    stress.yy[i] = points.back().stress.yy;
    stress.zz[i] = points.back().stress.zz;
    history.temperature[i] = points.back().history.temperature;
    history.internal_energy[i] = points.back().history.internal_energy;
    volume[i] = points.back().volume;
  }
  for (int step = 0; step < 40; ++step) {
    IncrementOf<Sym3Of<Lanes>> increment;
    increment.dt = Lanes{} + 1e-9;
    increment.volume_ratio_begin = volume;
    for (int i = 0; i < lane_count; ++i) {
      volume[i] = 1.0 + 0.05 * std::sin(0.3 * step * (1 + i));
      increment.viscous_pressure[i] = step % 3 == 0 ? 1e6 : 0.0;
      points[static_cast<std::size_t>(i)].go_to(volume[i], increment.viscous_pressure[i]);
    }
    increment.volume_ratio_end = volume;
    const auto outcome = model.update_points(increment, stress, history);
    for (int i = 0; i < lane_count; ++i) {
      const LiquidPoint& alone = points[static_cast<std::size_t>(i)];
      EXPECT_NEAR(stress.xx[i], alone.stress.xx, 1e-6);
      EXPECT_NEAR(history.void_volume[i], alone.history.void_volume, 1e-15);
      EXPECT_NEAR(history.internal_energy[i], alone.history.internal_energy, 1e-9);
      EXPECT_NEAR(history.temperature[i], alone.history.temperature, 1e-11);
      EXPECT_NEAR(outcome.longitudinal_modulus[i] / alone.modulus, 1.0, 1e-14);
    }
  }
}
#endif

TEST(Liquid, CardsStartAtRest) {
  for (const char* const name : {"water", "brine", "oil"}) {
    const Material card = material_open(name);
    const auto& model = std::get<Liquid>(card.model);
    const auto start = model.initial_state(0.0);
    EXPECT_TRUE(start.possible) << name;
    EXPECT_EQ(start.volume_ratio, 1.0) << name;
    EXPECT_LT(model.parameters().vapour_pressure, 0.0) << name;
    EXPECT_GT(model.parameters().vapour_pressure, -101325.0) << name;
  }
}

}  // namespace
}  // namespace barreno::test
