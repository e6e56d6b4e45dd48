// SPDX-License-Identifier: BSD-3-Clause
// The general form of Arenisca at the ends of its parameters' ranges.
#include "barreno/input/error.hpp"
#include "barreno/registry.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

/// Two legs that crush and shear, and a way back; in `steps` equal increments each.
std::vector<Sym3> stresses(const Parameters& p, int steps, double dt) {
  const GeneralArenisca model(p, 2300.0);
  Point<GeneralArenisca> point(model);
  const Sym3 legs[] = {
      {-0.02, -0.006, -0.001, 0.004, 0.002, -0.003},
      {-0.01, 0.002, -0.015, -0.004, 0.005, 0.003},
      {0.008, 0.003, 0.002, 0.001, 0.0, 0.0}};
  std::vector<Sym3> all;
  for (const Sym3& leg : legs) {
    for (int i = 0; i < steps; ++i) {
      EXPECT_FALSE(point.apply((1.0 / steps) * leg, dt).failed());
    }
    all.push_back(point.stress);
  }
  return all;
}

Material from_list(const char* name, double value) {
  Teuchos::ParameterList list;
  list.set("Model", std::string("Arenisca"));
  list.set("Density", 2300.0);
  const Parameters p = dry_rock();
  for (const auto& entry : Arenisca::parameter_table().numbers) {
    list.set(entry.name, p.*entry.member);
  }
  list.set(name, value);
  return make_material("rock", list);
}

/// A card without fluid, rate, angle and scatter gets the drained form itself, bit for bit.
TEST(GeneralLimits, NothingAskedForIsTheDrainedForm) {
  for (const char* name : {"fluid_B0", "T1_rate_dependence", "Weibull modulus"}) {
    EXPECT_TRUE(std::holds_alternative<Arenisca>(from_list(name, 0.0).model)) << name;
  }
  EXPECT_TRUE(std::holds_alternative<WetArenisca>(from_list("fluid_B0", 2.2e9).model));
  EXPECT_TRUE(std::holds_alternative<RatedArenisca>(from_list("T1_rate_dependence", 1e-6).model));
}

/// rho = rho_dry + phi rho_fluid where the card has Fluid Density, and else the card's own bits.
TEST(GeneralLimits, FluidInPoresWeighs) {
  Teuchos::ParameterList list;
  list.set("Model", std::string("Arenisca"));
  list.set("Density", 2120.0);
  const Parameters p = wet_rock();
  for (const auto& entry : Arenisca::parameter_table().numbers)
    list.set(entry.name, p.*entry.member);
  EXPECT_EQ(make_material("rock", list).density, 2120.0);
  list.set("Fluid Density", 1000.0);
  const double porosity = 1.0 - std::exp(-p.p3_crush_curve);
  EXPECT_NEAR(make_material("rock", list).density, 2120.0 + 1000.0 * porosity, 1e-9);
  list.set("fluid_B0", 0.0);
  list.set("fluid_pressure_initial", 0.0);
  EXPECT_THROW(make_material("rock", list), InputError);
}

/// Grains without pores hold no fluid.
TEST(GeneralLimits, FluidNeedsPores) {
  Parameters p = wet_rock();
  p.p3_crush_curve = 0.0;
  const auto with = stresses(p, 20, 1e-6);
  p.fluid_B0 = 0.0;
  EXPECT_EQ(largest_difference(with, stresses(p, 20, 1e-6)), 0.0);
}

/// tau -> 0: no overstress, to round-off; tau -> infinity: elastic, whatever the rock yields at.
TEST(GeneralLimits, RelaxationTimes) {
  Parameters p = wet_rock();
  const auto quasi_static = stresses(p, 20, 1e-6);
  p.T1_rate_dependence = 1e-30;
  EXPECT_LE(largest_difference(stresses(p, 20, 1e-6), quasi_static), 1e-14);

  Parameters elastic = dry_rock();
  elastic.B1 = elastic.B2 = 0.0;  // elastic moduli of another stress would be another response
  elastic.T1_rate_dependence = 1e30;
  const Sym3 total{-0.022, -0.001, -0.014, 0.001, 0.007, 0.0};
  const Sym3 hooke = (2.0 * elastic.G0) * deviator(total) + isotropic(elastic.B0 * trace(total));
  EXPECT_LE(norm(stresses(elastic, 20, 1e-6).back() - hooke) / norm(hooke), 1e-10);
}

/// T2 > 0 at rest: the relaxation time is infinite, the overstress stays. T2 = 0: it decays.
TEST(GeneralLimits, OverstressAtRest) {
  for (const double T2 : {0.0, 0.5}) {
    Parameters p = wet_rock();
    p.T1_rate_dependence = T2 > 0.0 ? 1e-4 : 1e-6;
    p.T2_rate_dependence = T2;
    const GeneralArenisca model(p, 2300.0);
    Point<GeneralArenisca> point(model);
    for (int i = 0; i < 20; ++i) {
      ASSERT_FALSE(point.apply({-0.002, 0, 0, 0.001, 0, 0}, 1e-6).failed());
    }
    const double over = point.history.overstress_xy;
    EXPECT_GT(std::fabs(over), 1e5);
    ASSERT_FALSE(point.apply(Sym3{}, 2e-6).failed());
    const double kept = T2 > 0.0 ? 1.0 : std::exp(-2.0);
    EXPECT_NEAR(point.history.overstress_xy / over, kept, 1e-12);
  }
}

/// One step against many: second order in the step, for every part of the model.
TEST(GeneralLimits, SecondOrderInTheStep) {
  std::vector<Parameters> rocks(3, wet_rock());
  rocks[1].J3_type = arenisca::Lode::willam_warnke;
  rocks[1].J3_psi = 0.7;
  rocks[2].T1_rate_dependence = 1e-3;
  for (Parameters& p : rocks) {
    p.tolerance = 1e-8;
    const double whole = 1e-3;
    const auto exact = stresses(p, 2048, whole / 2048);
    p.tolerance = 0.9;  // the steps are the substeps
    std::vector<double> errors;
    for (const int n : {32, 128, 512}) {
      errors.push_back(largest_difference(stresses(p, n, whole / n), exact));
    }
    const double order = 0.5 * std::log2(errors[0] / errors[2]) / 2.0;
    EXPECT_GE(order, 1.7) << errors[0] << ' ' << errors[1] << ' ' << errors[2];
    EXPECT_LE(errors[2], 1e-4);
  }
}

/// Rock without cohesion opens without stress and holds no fluid in its widened pores, until it is
/// compressed again.
TEST(GeneralLimits, NoCohesion) {
  Parameters p = wet_rock();
  p.PEAKI1 = 0.0;
  const GeneralArenisca model(p, 2300.0);
  Point<GeneralArenisca> point(model);
  for (int i = 0; i < 20; ++i) {
    ASSERT_FALSE(point.apply({1e-3, 9e-4, 8e-4, 1e-4, 0, 0}, 1e-6).failed());
    EXPECT_LE(norm(point.stress), 1e-3);
    EXPECT_EQ(point.history.pore_pressure, 0.0);
  }
  const double opened = point.history.porosity;
  for (int i = 0; i < 60; ++i) {
    ASSERT_FALSE(point.apply({-1e-3, -1e-3, -1e-3, 0, 0, 0}, 1e-6).failed());
  }
  EXPECT_GT(point.history.pore_pressure, 0.0);
  EXPECT_LT(point.history.porosity, opened);
}

/// Rock with fluid under pressure starts at its elastic centre: -p_i I, which stays without strain.
TEST(GeneralLimits, InitialPressure) {
  Parameters p = wet_rock();
  p.fluid_pressure_initial = 30e6;
  const GeneralArenisca model(p, 2300.0);
  const auto start = model.initial_state(0.0);
  EXPECT_NEAR(trace(start.stress) / -90e6, 1.0, 1e-14);
  EXPECT_NEAR(start.history.pore_pressure / 30e6, 1.0, 1e-14);
  Point<GeneralArenisca> point(model);
  point.stress = start.stress;
  point.history = start.history;
  ASSERT_FALSE(point.apply(Sym3{}, 1e-6).failed());
  EXPECT_LE(norm(point.stress - start.stress), 1e-6);
  // Undrained, dp = -B dI1/3 with Skempton's B at the centre.
  const auto& rock = model.rock();
  const double drained = rock.elasticity.moduli_at(0.0, 0.0).bulk;
  const double b = rock.fluid.skempton(drained, rock.fluid.porosity);
  ASSERT_FALSE(point.apply(isotropic(-1e-6), 1e-6).failed());
  const double rise = -(trace(point.stress) - trace(start.stress)) / 3.0;
  EXPECT_NEAR((point.history.pore_pressure - 30e6) / (b * rise), 1.0, 1e-6);
}

/// First yield anywhere in a step, at its very end too: round-off must not leave a remainder that
/// is never taken.
TEST(GeneralLimits, TheSurfaceMayBeReachedAnywhereInAStep) {
  const GeneralArenisca model(wet_rock(), 2300.0);
  const Sym3 ways[] = {
      {1.0, 1.0, 1.0, 0.3, -0.2, 0.4},
      {-1.0, 0.6, 0.5, 0.3, -0.2, 0.4},
      {-1.0, -0.9, -1.2, 0.3, 0.1, 0.0}};
  for (const Sym3& way : ways) {
    double inside = 0.0, outside = 0.1;
    const auto try_step = [&](double size) {
      Point<GeneralArenisca> point(model);
      EXPECT_FALSE(point.apply(size * way, 1e-6).failed()) << size;
      EXPECT_LE(point.last.substeps, 100) << size;
      return point.last.plastic_work > 0.0;
    };
    for (int i = 0; i < 80; ++i) {  // until the two are neighbours
      const double middle = 0.5 * (inside + outside);
      (try_step(middle) ? outside : inside) = middle;
    }
    for (int i = 0; i < 20000; ++i) try_step(outside * (1.0 + 1e-4 * i));
  }
}

}  // namespace
}  // namespace barreno::test
