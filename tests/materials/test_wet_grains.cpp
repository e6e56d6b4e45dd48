// SPDX-License-Identifier: BSD-3-Clause
/// Wet rock under the pressures of a jet: grains and fluid whose moduli follow the pressure
/// (docs/method.md, 10.6 to 10.9), against equations written anew.
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

/// Quartz that turns into a denser phase, and water.
Parameters jet_rock() {
  Parameters p = Sample<WetArenisca>::parameters();
  p.grain_stiffening = 5.0;
  p.fluid_stiffening = 8.0;
  p.transition_strain = 0.2;
  p.transition_start = 12e9;
  p.transition_end = 35e9;
  return p;
}
/// The same grains in rock that is too strong to yield, and whose pores stay soft.
Parameters strong_rock() {
  Parameters p = jet_rock();
  p.B1 = p.B2 = 0.0;
  p.matrix_bulk_modulus = 36e9;
  p.p0_crush_curve = -1e12;
  p.p1_crush_curve = 1e-12;
  p.PEAKI1 = 1e12;
  p.tolerance = 1e-7;
  return p;
}

/// The equations written anew, in plain numbers.
struct Laws {
  Parameters p;
  double matrix = p.matrix_bulk_modulus > 0.0 ? p.matrix_bulk_modulus : p.B0 + p.B1;

  double way(double pressure) const {
    const double w = (pressure - p.transition_start) / (p.transition_end - p.transition_start);
    return std::fmin(std::fmax(w, 0.0), 1.0);
  }
  double transition_compliance(double pressure) const {
    if (p.transition_strain == 0.0) return 0.0;
    const double w = way(pressure);
    return 6.0 * p.transition_strain * w * (1.0 - w) / (p.transition_end - p.transition_start);
  }
  double grain_compliance(double pressure) const {
    return 1.0 / (matrix + p.grain_stiffening * pressure) + transition_compliance(pressure);
  }
  double grain_strain(double pressure) const {
    const double w = p.transition_strain > 0.0 ? way(pressure) : 0.0;
    return std::log1p(p.grain_stiffening * pressure / matrix) / p.grain_stiffening +
           p.transition_strain * w * w * (3.0 - 2.0 * w);
  }
  double fluid_compliance(double pressure) const {
    return 1.0 / (p.fluid_B0 + p.fluid_stiffening * pressure);
  }
  double fluid_strain(double pressure) const {
    return std::log1p(p.fluid_stiffening * pressure / p.fluid_B0) / p.fluid_stiffening;
  }
  /// 1/K of dry rock that is not crushed.
  double dry_compliance(double effective) const {
    const double share = effective > 0.0 ? std::exp(-p.B2 / (3.0 * effective)) : 0.0;
    return 1.0 / (p.B0 + (p.B1 + p.grain_stiffening * effective) * share) +
           (effective > 0.0 ? transition_compliance(effective) : 0.0);
  }
  /// Compliance of the pores: that of dry rock, and what (10.9) asks for at least.
  double of_pores(double effective, double pressure, double porosity) const {
    const double whole = grain_compliance(effective + pressure);
    const double excess =
        porosity * (grain_compliance(pressure) - 0.5 * fluid_compliance(pressure));
    const double asked = std::fmin(std::fmax(excess, 0.0), 0.9 * whole);
    const double dry = dry_compliance(effective) - grain_compliance(effective);
    return std::fmax(dry, asked * whole / (whole - asked));
  }
};

/// Elastic rock compressed without a way out for its fluid, as the pressure of the fluid rises:
/// pores close by what their fluid gives way beyond the grains, and the rest is compressed alike.
///
///   s dP' = phi (1/Kf - 1/Km) dp,   d ln J = -(1/Km(P) + s) dP' - dp/Km(P)
struct Undrained {
  Laws laws;
  double porosity_at_start;
  double pressure = 0.0, effective = 0.0, volume = 0.0;  ///< p, P', ln J

  double porosity(double p, double ln_J) const {
    return porosity_at_start * std::exp(-laws.fluid_strain(p) - ln_J);
  }
  void slopes(double p, double P, double ln_J, double& dP, double& dv) const {
    const double phi = porosity(p, ln_J), s = laws.of_pores(P, p, phi);
    dP = phi * (laws.fluid_compliance(p) - laws.grain_compliance(p)) / s;
    const double whole = laws.grain_compliance(P + p);
    dv = -(whole + s) * dP - whole;
  }
  /// Runge and Kutta's fourth order.
  void to(double end, int steps) {
    const double h = (end - pressure) / steps;
    for (int i = 0; i < steps; ++i) {
      double k[4], v[4];
      slopes(pressure, effective, volume, k[0], v[0]);
      for (int j = 1; j < 4; ++j) {
        const double part = j == 3 ? h : 0.5 * h;
        slopes(pressure + part, effective + part * k[j - 1], volume + part * v[j - 1], k[j], v[j]);
      }
      effective += h / 6.0 * (k[0] + 2.0 * k[1] + 2.0 * k[2] + k[3]);
      volume += h / 6.0 * (v[0] + 2.0 * v[1] + 2.0 * v[2] + v[3]);
      pressure += h;
    }
  }
};

/// A wet point under hydrostatic strain.
struct Squeezed {
  WetArenisca model;
  Sym3 stress{};
  WetArenisca::History history;
  double strain = 0.0, work = 0.0, plastic = 0.0, mean_pressures = 0.0;

  explicit Squeezed(const Parameters& p) : model(p, 2300.0), history(model.initial_history()) {}
  void to(double volume_strain, int steps) {
    const double part = (volume_strain - strain) / steps;
    for (int i = 0; i < steps; ++i) {
      Increment increment{};
      increment.strain = isotropic(part / 3.0);
      increment.volume_ratio_begin = std::exp(strain + i * part);
      increment.volume_ratio_end = std::exp(strain + (i + 1) * part);
      const Outcome outcome = model.update(increment, stress, history);
      ASSERT_FALSE(outcome.failed());
      work += outcome.elastic_work;
      plastic += outcome.plastic_work;
    }
    strain = volume_strain;
  }
  double pressure() const { return -trace(stress) / 3.0; }
  double effective() const { return pressure() - history.pore_pressure; }
};

const double places[] = {1e7, 1e8, 1e9, 5e9, 10e9, 13e9, 20e9, 30e9, 36e9, 40e9};

/// Total and effective pressure at the places, of a point that takes so many steps between them.
std::vector<std::pair<double, double>> pressures_of(const Parameters& p, int steps) {
  Undrained exact{{p}, -std::expm1(-p.p3_crush_curve)};
  Squeezed point(p);
  std::vector<std::pair<double, double>> found;
  for (const double pressure : places) {
    exact.to(pressure, 20000);
    point.to(exact.volume, steps);
    found.emplace_back(point.pressure(), point.effective());
  }
  return found;
}

/// The error is of first order in the step (the volume of grains over the volume is that of the
/// start of a step); what twice as many steps tell without it is the solution.
TEST(WetGrains, UndrainedCompressionIsThatOfTheEquations) {
  const Parameters p = strong_rock();
  const auto coarse = pressures_of(p, 2000), fine = pressures_of(p, 4000);
  Undrained exact{{p}, -std::expm1(-p.p3_crush_curve)};
  for (std::size_t i = 0; i < fine.size(); ++i) {
    exact.to(places[i], 20000);
    const double total = exact.effective + exact.pressure;
    EXPECT_NEAR(fine[i].first / total, 1.0, 1e-6) << places[i];
    const double without = 2.0 * fine[i].first - coarse[i].first;
    EXPECT_NEAR(without / total, 1.0, 1e-8) << places[i];
    const double effective = 2.0 * fine[i].second - coarse[i].second;
    EXPECT_NEAR(effective, exact.effective, 1e-8 * total) << places[i];
  }
}

/// The volumes of fluid and grains, under one pressure but for what the skeleton bears, tell the
/// density of rock that is crushed on the way.
TEST(WetGrains, CrushedRockIsAsDenseAsGrainsAndFluidUnderOnePressure) {
  const Parameters p = jet_rock();
  const Laws laws{p};
  Squeezed point(p);
  const double porosity = -std::expm1(-p.p3_crush_curve);
  for (double strain = -0.02; point.pressure() < 40e9; strain -= 0.02) {
    point.to(strain, 40);
    const double total = point.pressure(), pore = point.history.pore_pressure;
    const double solid = 1.0 - point.history.porosity;
    const double own = laws.grain_strain(total) - (1.0 - solid) * laws.grain_strain(pore);
    const double fluid = porosity * std::exp(-laws.fluid_strain(pore));
    // The exponent has the porosity of every step; the effective pressure is what it matters for.
    const double grains = (1.0 - porosity) * std::exp(-own / solid);
    EXPECT_NEAR(std::exp(strain), grains + fluid, 3e-3 * std::exp(strain)) << total;
    // The mass of fluid is conserved to the tolerance of the solution.
    EXPECT_NEAR(point.history.porosity * std::exp(strain), fluid, 1e-11) << total;
    // Fluid that is stiffer than the grains presses them apart, to the tensile strength.
    EXPECT_GE(point.effective(), -(1.0 + 1e-6) / 3.0 * p.PEAKI1);
  }
  EXPECT_GT(point.strain, -0.8);
}

/// What compression to 40 GPa takes, elastic release gives back.
TEST(WetGrains, HydrostaticCycleCreatesNoWork) {
  const Parameters p = strong_rock();
  double last = 0.0;
  for (const int steps : {1000, 4000}) {
    Undrained exact{{p}, -std::expm1(-p.p3_crush_curve)};
    exact.to(40e9, 40000);
    Squeezed point(p);
    point.to(exact.volume, steps);
    const double stored = point.work;
    EXPECT_GT(stored, 2e9);
    point.to(0.0, steps);
    EXPECT_LT(std::fabs(point.work), 1e-4 * stored);
    EXPECT_LT(point.pressure(), 1e-5 * 40e9);
    if (last > 0.0) {
      EXPECT_LT(std::fabs(point.work), 0.3 * last);
    }
    last = std::fabs(point.work);
  }
}

/// A state of rock under an effective and a pore pressure.
WetArenisca::History at_rest(
    const WetArenisca& model, double effective, double pore, Sym3& stress
) {
  const auto start = model.initial_state(effective + pore, pore);
  stress = start.stress;
  return start.history;
}

/// Stiffness and rise of the pore pressure of rock whose fluid cannot leave, from a small step
/// against Gassmann's relations with the tangents at the pressures of grains and fluid.
TEST(WetGrains, TangentsAreGassmannsAtThePressuresOfGrainsAndFluid) {
  const Parameters p = strong_rock();
  const Laws laws{p};
  const WetArenisca model(p, 2300.0);
  for (const double pore : {1e6, 1e8, 2e9, 10e9, 20e9, 33e9}) {
    for (const double effective : {1e6, 1e8, 0.7e9}) {
      Sym3 stress{};
      const WetArenisca::History history = at_rest(model, effective, pore, stress);
      const double total = effective + pore, phi = history.porosity;
      const double s = laws.of_pores(effective, pore, phi), h = laws.grain_compliance(total);
      const double biot = s / (s + h);
      const double storage =
          biot * h + phi * (laws.fluid_compliance(pore) - laws.grain_compliance(pore));
      const double undrained = 1.0 / (s + h) + biot * biot / storage;
      const double shear = model.drained_moduli(stress, history).shear;
      EXPECT_NEAR(
          model.longitudinal_modulus(stress, history, 1.0) - 4.0 / 3.0 * shear,
          undrained,
          1e-10 * undrained
      );
      const PorePoint point = model.pore_point(stress, history);
      EXPECT_NEAR(point.biot, biot, 1e-10);
      EXPECT_NEAR(point.storage, storage, 1e-9 * storage);
      double mean[2], fluid[2];
      const double step = 1e-6;
      for (const int side : {0, 1}) {
        Sym3 end = stress;
        WetArenisca::History h_end = history;
        Increment increment{};
        increment.strain = isotropic((side == 0 ? -step : step) / 3.0);
        ASSERT_FALSE(model.update(increment, end, h_end).failed());
        mean[side] = -trace(end) / 3.0;
        fluid[side] = h_end.pore_pressure;
      }
      EXPECT_NEAR((mean[0] - mean[1]) / (2.0 * step), undrained, 1e-6 * undrained);
      EXPECT_NEAR((fluid[0] - fluid[1]) / (mean[0] - mean[1]), biot / storage / undrained, 1e-6)
          << pore << " " << effective;
    }
  }
}

/// Far below the moduli stiffening is nothing: the difference is in proportion to the pressure.
TEST(WetGrains, TendsToConstantModuliAtLowPressure) {
  Parameters constant = jet_rock();
  constant.grain_stiffening = constant.fluid_stiffening = constant.transition_strain = 0.0;
  constant.transition_start = constant.transition_end = 0.0;
  double last = 0.0;
  for (const double strain : {-1e-5, -1e-4, -1e-3}) {
    Squeezed changing(jet_rock()), other(constant);
    changing.to(strain, 100);
    other.to(strain, 100);
    const double off = changing.pressure() / other.pressure() - 1.0;
    EXPECT_GT(off, 0.0);
    EXPECT_LT(off, 10.0 * changing.pressure() / constant.fluid_B0);
    if (last > 0.0) {
      EXPECT_NEAR(off / last, 10.0, 2.0);
    }
    last = off;
  }
}

/// A crushed point is drained: its state is that of the dry rock under the same strain.
TEST(WetGrains, IsDryRockAfterItsFluidHasGone) {
  Parameters p = jet_rock();
  p.tolerance = 1e-5;
  const WetArenisca model(p, 2300.0);
  Parameters without = p;
  without.fluid_B0 = without.fluid_stiffening = 0.0;
  const Arenisca dry(without, 2300.0);
  for (const double strain : {-0.003, -0.02, -0.06}) {
    constexpr int steps = 50;
    Point<WetArenisca> wet(model);
    Point<Arenisca> other(dry);
    for (int i = 0; i < steps; ++i) {
      ASSERT_FALSE(wet.apply(isotropic(strain / steps), 0.0).failed());
      ASSERT_FALSE(other.apply(isotropic(strain / steps), 0.0).failed());
    }
    EXPECT_GT(wet.history.pore_pressure, 20e6);
    for (int i = 0; i < 400 && wet.history.gas == 0.0; ++i) {
      const PorePoint fluid = model.pore_point(wet.stress, wet.history);
      const double volume =
          -std::fmin(0.02 * fluid.porosity, fluid.fluid_mass / fluid.mass_per_volume);
      ASSERT_FALSE(model.drain(volume, wet.stress, wet.history).failed());
    }
    ASSERT_EQ(wet.history.pore_pressure, 0.0);
    const double off = norm(wet.stress - other.stress) / norm(other.stress);
    EXPECT_LE(off, 1e-3) << strain;
  }
}

/// Rock with a trace of fluid is dry rock, at first order, until its pores are nearly closed.
TEST(WetGrains, TendsToDryRockAtFirstOrderInTheFluid) {
  Parameters p = jet_rock();
  p.fluid_stiffening = 0.0;
  p.tolerance = 1e-6;
  Parameters without = p;
  without.fluid_B0 = 0.0;
  const Arenisca dry(without, 2300.0);
  double last = 0.0;
  for (const double fluid : {1e5, 1e4, 1e3}) {
    p.fluid_B0 = fluid;
    const WetArenisca model(p, 2300.0);
    Point<WetArenisca> wet(model);
    Point<Arenisca> other(dry);
    double worst = 0.0;
    for (int i = 0; i < 110; ++i) {
      const Sym3 strain{-1e-3, -5e-4, -5e-4, 2e-4, 0.0, 0.0};
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

/// Whatever the skeleton and the fluid bear: 0 <= alpha <= 1, and full pores store half of what
/// their fluid alone does, or more, (10.9).
TEST(WetGrains, PoresStoreInEveryState) {
  const WetArenisca model(jet_rock(), 2300.0);
  const Laws laws{jet_rock()};
  int bounded = 0;
  for (double pore = 1e6; pore < 41e9; pore += 0.5e9) {
    for (const double effective : {0.0, 0.1e9, 0.5e9, 1e9, 3e9, 10e9, 40e9}) {
      for (const double porosity : {1e-4, 0.05, 0.2, 0.4}) {
        WetArenisca::History h = model.initial_history();
        h.pore_pressure = pore;
        h.porosity = porosity;
        const PorePoint point = model.pore_point(isotropic(-pore - effective), h);
        const double fluid = laws.fluid_compliance(pore);
        EXPECT_GE(point.biot, 0.0);
        EXPECT_LE(point.biot, 1.0);
        if (effective > 5e9) continue;
        EXPECT_GE(point.storage, (0.5 - 1e-9) * porosity * fluid) << pore << " " << effective;
        bounded += point.storage < (0.5 + 1e-9) * porosity * fluid;
      }
    }
  }
  EXPECT_GT(bounded, 10);
}

/// Steps of every size between states of every kind are solved.
TEST(WetGrains, LongStepsAreSolved) {
  for (const double size : {-0.3, -0.1, -0.03, -1e-3}) {
    Squeezed point(jet_rock());
    for (double strain = size; strain > -0.61; strain += size) point.to(strain, 1);
    EXPECT_GT(point.pressure(), 20e9);
    point.to(-1e-3, 1);
    EXPECT_LT(point.pressure(), 2e9);
  }
}

TEST(WetGrains, AreRefusedWhereTheyContradict) {
  const auto fault = [](auto change) {
    Parameters p = jet_rock();
    change(p);
    return Arenisca::check(p, 2300.0);
  };
  const auto names = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  EXPECT_EQ(fault([](Parameters&) {}), "");
  EXPECT_EQ(fault([](Parameters& p) { p.transition_strain = 0.4; }), "");
  EXPECT_TRUE(
      names(fault([](Parameters& p) { p.fluid_B0 = 0.0; }), "Fluid stiffening = 8 needs a fluid")
  );
  EXPECT_TRUE(names(
      fault([](Parameters& p) {
        p.grain_stiffening = p.transition_strain = p.transition_start = p.transition_end = 0.0;
      }),
      "Fluid stiffening = 8 makes the fluid less compressible than the grains"
  ));
  for (const int form : {Parameters::elastic_centre, Parameters::plastic_backstress}) {
    EXPECT_TRUE(names(
        fault([form](Parameters& p) { p.backstress_strain = form; }),
        "Grain stiffening = 5 goes with fluid_B0 only in the form Backstress strain = poroplastic"
    ));
    EXPECT_TRUE(names(
        fault([form](Parameters& p) {
          p.backstress_strain = form;
          p.grain_stiffening = p.transition_strain = p.transition_start = p.transition_end = 0.0;
          p.fluid_stiffening = 1.0;
        }),
        "Fluid stiffening = 1 goes with"
    ));
  }
}

/// Heated grains expand by their own bulk modulus, at the pressure that they are under.
TEST(WetGrains, HeatExpandsThemByTheirOwnModulus) {
  Parameters p = jet_rock();
  p.matrix_bulk_modulus = 40e9;
  p.specific_heat = 1000.0;
  p.grueneisen = 0.7;
  p.grain_density = 2650.0;
  const HeatedWetArenisca model(p, 2300.0);
  HeatedWetArenisca::History h = model.initial_history();
  h.pore_pressure = 8e9;
  model.add_heat(1e5, isotropic(-10e9), h);
  EXPECT_NEAR(h.thermal_expansion, 0.7 * 2650.0 * 1e5 / (40e9 + 5.0 * 10e9), 1e-16);
}

}  // namespace
}  // namespace barreno::test
