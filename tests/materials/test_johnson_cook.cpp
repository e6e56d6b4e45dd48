// SPDX-License-Identifier: BSD-3-Clause
/// Johnson-Cook and Mie-Grueneisen against closed forms.

#include "barreno/models/metals.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

using CopperPoint = Point<JohnsonCook>;

double equivalent(const Sym3& stress) {
  return std::sqrt(3.0 * second_invariant(deviator(stress)));
}
double pressure(const Sym3& stress) {
  return -trace(stress) / 3.0;
}

/// Copper without rate, thermal softening and power hardening: J2 plasticity with linear hardening.
JohnsonCook::Parameters linear_hardening() {
  auto p = Sample<JohnsonCook>::parameters();
  p.b = 500e6;
  p.n = 1.0;
  p.c = 0.0;
  p.m = 1.0;
  p.melt_temperature = 1e30;
  return p;
}

struct ShockCase {
  const char* metal;
  MieGruneisen eos;
  double particle_speed, pressure;  // m/s, Pa: design/verification.md 3.3
};
std::vector<ShockCase> shock_cases() {
  const MieGruneisen copper{8930.0, 3940.0, 1.489, 2.02}, aluminium{2703.0, 5350.0, 1.34, 2.0};
  const MieGruneisen steel{7896.0, 4569.0, 1.49, 2.17};
  return {
      {"Cu", copper, 100.0, 3.651387700e9},
      {"Cu", copper, 1000.0, 4.848097000e10},
      {"Cu", copper, 3000.0, 2.252235300e11},
      {"Cu", copper, 5000.0, 5.083402500e11},
      {"Al", aluminium, 100.0, 1.482325200e9},
      {"Al", aluminium, 1000.0, 1.808307000e10},
      {"Al", aluminium, 3000.0, 7.598133000e10},
      {"Al", aluminium, 5000.0, 1.628557500e11},
      {"Steel", steel, 100.0, 3.725332800e9},
      {"Steel", steel, 1000.0, 4.784186400e10},
      {"Steel", steel, 3000.0, 2.141158320e11},
      {"Steel", steel, 5000.0, 4.745101200e11}};
}

TEST(MieGruneisen, HugoniotStatesLieOnTheSurface) {
  for (const ShockCase& c : shock_cases()) {
    const double shock_speed = c.eos.sound_speed + c.eos.slope * c.particle_speed;
    const double eta = c.particle_speed / shock_speed;
    const double jump = c.eos.density * shock_speed * c.particle_speed;
    const double p = c.eos.pressure(eta, 0.5 * c.particle_speed * c.particle_speed);
    EXPECT_NEAR(p / jump, 1.0, 1e-12) << c.metal;
    EXPECT_NEAR(p / c.pressure, 1.0, 1e-9) << c.metal << ": digits of the table";
  }
  const MieGruneisen tungsten{19300.0, 4030.0, 1.237, 1.67};
  for (const double up : {100.0, 1000.0, 3000.0, 5000.0}) {
    const double shock_speed = tungsten.sound_speed + tungsten.slope * up;
    const double p = tungsten.pressure(up / shock_speed, 0.5 * up * up);
    EXPECT_NEAR(p / (tungsten.density * shock_speed * up), 1.0, 1e-12);
  }
}

TEST(MieGruneisen, DerivativeAndIsentropeAgreeWithDifferences) {
  const MieGruneisen eos{8930.0, 3940.0, 1.489, 2.02};
  for (const double eta : {-0.05, 0.01, 0.1, 0.3, 0.5}) {
    constexpr double h = 1e-6;
    const double up = eos.reference(eta + h).pressure, down = eos.reference(eta - h).pressure;
    EXPECT_NEAR((up - down) / (2 * h) / eos.reference(eta).derivative, 1.0, 1e-8);
  }
  // On the isentrope dE/deta = P and rho c^2 = V dP/deta.
  for (const double eta : {0.01, 0.1, 0.3}) {
    constexpr double h = 1e-5;
    const auto p_at = [&](double x) {
      return eos.pressure(x, eos.isentrope_energy(x) / eos.density);
    };
    const double p = p_at(eta);
    const double dE = (eos.isentrope_energy(eta + h) - eos.isentrope_energy(eta - h)) / (2 * h);
    const double dP = (p_at(eta + h) - p_at(eta - h)) / (2 * h);
    EXPECT_NEAR(dE / p, 1.0, 1e-7);
    EXPECT_NEAR((1 - eta) * dP / eos.isentropic_modulus(eta, eos.reference(eta), p), 1.0, 1e-7);
  }
}

/// Tungsten whose atoms come apart at 4.6 MJ/kg.
MieGruneisen tungsten_that_comes_apart() {
  return MieGruneisen::make({134.0, 4030.0, 1.237, 1.67, 4.6e6}, 17600.0);
}
double volume_to_eta(double volume_ratio) {
  return 1.0 - volume_ratio;
}

TEST(MieGruneisen, ColdTensionTakesTheCohesiveEnergyAndThenEnds) {
  const MieGruneisen eos = tungsten_that_comes_apart();
  // e on the cold curve follows its own pressure: de = -p dV / rho0 (Runge and Kutta).
  double energy = 0.0, largest = 0.0, v = 1.0;
  constexpr double d = 1e-3;
  const auto rate = [&](double x, double e) { return -eos.pressure(1.0 - x, e) / eos.density; };
  for (; v < 12.0; v += d) {
    const double k1 = rate(v, energy), k2 = rate(v + 0.5 * d, energy + 0.5 * d * k1);
    const double k3 = rate(v + 0.5 * d, energy + 0.5 * d * k2), k4 = rate(v + d, energy + d * k3);
    energy += d / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    largest = std::max(largest, -eos.pressure(1.0 - (v + d), energy));
  }
  EXPECT_NEAR(energy / eos.cohesive_energy, 1.0, 1e-6);
  EXPECT_NEAR(largest / (eos.bulk_modulus() / (std::exp(1.0) * eos.fading)), 1.0, 1e-6);
  EXPECT_NEAR(eos.pressure(1.0 - v, energy) / eos.bulk_modulus(), 0.0, 1e-6);
}

TEST(MieGruneisen, ExpandedMetalThatIsHotIsAGasAndHasItsSoundSpeed) {
  const MieGruneisen eos = tungsten_that_comes_apart();
  // 0.19 of its density with 10 MJ/kg: tungsten as a gas of Gamma 0.5 has 17 GPa and 2.7 km/s.
  const double eta = volume_to_eta(1.0 / 0.19), e = 10e6;
  const double p = eos.pressure(eta, e);
  EXPECT_GT(p, 10e9);
  EXPECT_LT(p, 25e9);
  const double modulus = eos.isentropic_modulus(eta, eos.reference(eta), p);
  const double speed = std::sqrt(modulus / (0.19 * eos.density));
  EXPECT_GT(speed, 2.2e3);
  EXPECT_LT(speed, 3.4e3);
  // Far out nothing is left but atoms: p = 2/3 rho (e - Ec).
  const double thin = eos.pressure(volume_to_eta(1e4), e) / (1e-4 * eos.density * (e - 4.6e6));
  EXPECT_NEAR(thin, 2.0 / 3.0, 2e-4);
}

TEST(MieGruneisen, ExpandedStatesAgreeWithDifferencesAndMeetTheCompressedOnes) {
  const MieGruneisen eos = tungsten_that_comes_apart();
  for (const double v : {1.01, 1.2, 1.5, 2.5, 6.0, 40.0}) {
    const double h = 1e-6 * v, eta = 1.0 - v;
    const auto at = eos.reference(eta);
    const auto up = eos.reference(eta + h), down = eos.reference(eta - h);
    EXPECT_NEAR((up.pressure - down.pressure) / (2 * h), at.derivative, 1e-8 * eos.bulk_modulus());
    EXPECT_NEAR((up.per_energy - down.per_energy) / (2 * h) / at.per_energy_derivative, 1.0, 1e-6);
    // On an isentrope dE/deta = P.
    const double e = 8e6, p = eos.pressure(eta, e);
    const double change = p * h / eos.density;
    const double rise =
        (eos.pressure(eta + h, e + change) - eos.pressure(eta - h, e - change)) / (2 * h);
    EXPECT_NEAR((1.0 - eta) * rise / eos.isentropic_modulus(eta, at, p), 1.0, 1e-5) << v;
  }
  const double tiny = 1e-9, e = 2e6;
  EXPECT_NEAR(eos.pressure(tiny, e) / eos.pressure(-tiny, e), 1.0, 1e-7);
  EXPECT_NEAR(eos.reference(tiny).derivative / eos.reference(-tiny).derivative, 1.0, 1e-7);
  const auto jump =
      eos.reference(-tiny).per_energy_derivative - eos.reference(tiny).per_energy_derivative;
  EXPECT_NEAR(jump, 2.0 * 1.67 - 2.0 / 3.0, 1e-7);
}

TEST(MieGruneisen, MetalWithoutGammaThatComesApartKeepsItsModulus) {
  const MieGruneisen eos = MieGruneisen::make({134.0, 4030.0, 1.237, 0.0, 4.6e6}, 17600.0);
  MieGruneisen whole = eos;
  whole.cohesive_energy = 0.0;
  for (const double eta : {0.0, 0.01, 0.2}) {
    const double p = eos.pressure(eta, 2e6);
    const double modulus = whole.isentropic_modulus(eta, whole.reference(eta), p);
    EXPECT_EQ(eos.isentropic_modulus(eta, eos.reference(eta), p), modulus) << eta;
  }
  EXPECT_TRUE(std::isfinite(eos.isentropic_modulus(-0.3, eos.reference(-0.3), 1e9)));
}

TEST(MieGruneisen, TheRelaxedVolumeOfMetalThatComesApartHasNoPressure) {
  const MieGruneisen eos = tungsten_that_comes_apart();
  for (const double e : {-1e3, 0.0, 1e4, 3e5, 1e6, 1.5e6}) {
    const double eta = eos.relaxed_compression(e);
    EXPECT_NEAR(eos.pressure(eta, e) / eos.bulk_modulus(), 0.0, 1e-9) << e;
  }
  // With so much energy it has pressure at any volume, and no volume is relaxed.
  EXPECT_GE(eos.pressure(eos.relaxed_compression(5e6), 5e6), 0.0);
}

/// Compress along a steady shock: p + q on the Rayleigh line rho0 Us^2 eta, strain without shear.
void compress_along_rayleigh_line(CopperPoint& point, double particle_speed, int steps) {
  const MieGruneisen& eos = point.model.equation_of_state();
  const double shock_speed = eos.sound_speed + eos.slope * particle_speed;
  const double eta_end = particle_speed / shock_speed;
  for (int i = 0; i < steps; ++i) {
    const double eta_0 = eta_end * i / steps, eta_1 = eta_end * (i + 1) / steps;
    const double total = eos.density * shock_speed * shock_speed * 0.5 * (eta_0 + eta_1);
    Increment increment{};
    increment.dt = 1e-9;
    increment.strain = isotropic(std::log((1.0 - eta_1) / (1.0 - eta_0)) / 3.0);
    increment.volume_ratio_begin = 1.0 - eta_0;
    increment.volume_ratio_end = 1.0 - eta_1;
    // The viscosity of the step must balance the mean pressure, which depends on its heat.
    Sym3 stress = point.stress;
    for (int k = 0; k < 20; ++k) {
      increment.viscous_pressure = total - 0.5 * (pressure(point.stress) + pressure(stress));
      stress = point.stress;
      auto history = point.history;
      ASSERT_FALSE(point.model.update(increment, stress, history).failed());
    }
    ASSERT_FALSE(point.model.update(increment, point.stress, point.history).failed());
    point.volume_ratio = increment.volume_ratio_end;
  }
}

TEST(JohnsonCook, ShockInManyStepsEndsOnTheHugoniot) {
  const auto model = sample_model<JohnsonCook>();
  const MieGruneisen& eos = model.equation_of_state();
  for (const double up : {100.0, 1000.0, 3000.0}) {
    CopperPoint point(model);
    compress_along_rayleigh_line(point, up, 400);
    const double jump = eos.density * (eos.sound_speed + eos.slope * up) * up;
    EXPECT_NEAR(pressure(point.stress) / jump, 1.0, 1e-10);
    EXPECT_NEAR(point.history.internal_energy / (0.5 * up * up), 1.0, 1e-10);
    // e - e_s(eta) = c (T - T_s(eta)): the temperature belongs to the same material.
    const double eta = 1.0 - point.volume_ratio;
    const double e_s = eos.isentrope_energy(eta) / eos.density;
    const double t_s = 294.0 * std::exp(eos.gamma * eta);
    const double t = t_s + (point.history.internal_energy - e_s) / model.parameters().specific_heat;
    EXPECT_NEAR(point.history.temperature / t, 1.0, 1e-5);
  }
}

TEST(JohnsonCook, WithoutViscousHeatTheCompressionIsIsentropic) {
  const auto model = sample_model<JohnsonCook>();
  const MieGruneisen& eos = model.equation_of_state();
  std::vector<double> errors;
  for (const int n : {50, 100, 200}) {
    CopperPoint point(model);
    for (int i = 0; i < n; ++i) ASSERT_FALSE(point.apply(isotropic(-0.1 / n), 1e-8).failed());
    const double eta = 1.0 - point.volume_ratio;
    const double p = eos.pressure(eta, eos.isentrope_energy(eta) / eos.density);
    errors.push_back(std::fabs(pressure(point.stress) / p - 1.0));
    EXPECT_NEAR(point.history.temperature / (294.0 * std::exp(eos.gamma * eta)), 1.0, 1e-4);
  }
  EXPECT_LT(errors[0], 1e-4);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.1);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.1);
}

TEST(JohnsonCook, InitialStateLiesOnTheIsentrope) {
  const auto model = sample_model<JohnsonCook>();
  const MieGruneisen& eos = model.equation_of_state();
  for (const double p : {0.0, 68.95e6, 1e9, 50e9}) {
    const auto state = model.initial_state(p);
    ASSERT_TRUE(state.possible);
    const double eta = 1.0 - state.volume_ratio;
    EXPECT_NEAR(pressure(state.stress), p, 1e-12 * p);
    EXPECT_NEAR(state.stored_energy, eos.isentrope_energy(eta), 1e-12 * state.stored_energy);
    EXPECT_DOUBLE_EQ(state.history.internal_energy * eos.density, state.stored_energy);
  }
  EXPECT_FALSE(model.initial_state(-1.0).possible);
  EXPECT_FALSE(model.initial_state(1e16).possible);
  EXPECT_FALSE(model.initial_state(std::nan("")).possible);
}

// Pressure on the isentrope falls before the compression limit, and is negative there.
TEST(JohnsonCook, ALargeGruneisenStartsWithoutPressure) {
  auto parameters = Sample<JohnsonCook>::parameters();
  parameters.gamma = 3.8;
  const JohnsonCook model(parameters, 8930.0);
  for (const double p : {0.0, 68.95e6, 50e9}) {
    const auto state = model.initial_state(p);
    ASSERT_TRUE(state.possible) << p;
    EXPECT_NEAR(pressure(state.stress), p, 1e-12 * p);
    EXPECT_LT(1.0 - state.volume_ratio, 0.5);
  }
  EXPECT_FALSE(model.initial_state(1e16).possible);
}

TEST(JohnsonCook, UniaxialStrainIsExactJ2) {
  const auto parameters = linear_hardening();
  const JohnsonCook model(parameters, 8930.0);
  const double shear = parameters.shear_modulus;
  for (const int n : {1, 7, 100}) {
    CopperPoint point(model);
    const double strain = -0.03;
    for (int i = 0; i < n; ++i)
      ASSERT_FALSE(point.apply({strain / n, 0, 0, 0, 0, 0}, 1e-8).failed());
    // 2 G |strain| = 3 G ep + A + B ep
    const double ep =
        (2.0 * shear * std::fabs(strain) - parameters.a) / (3.0 * shear + parameters.b);
    EXPECT_NEAR(point.history.plastic_strain, ep, 1e-12 * ep);
    const double flow = parameters.a + parameters.b * ep;
    EXPECT_NEAR(point.stress.yy - point.stress.xx, flow, 1e-11 * flow);
    EXPECT_NEAR(point.stress.yy, point.stress.zz, 1e-12 * pressure(point.stress));
  }
}

TEST(JohnsonCook, SteadyShearFlowsAtTheRateStress) {
  auto parameters = Sample<JohnsonCook>::parameters();
  parameters.b = 0.0;
  parameters.melt_temperature = 1e30;
  const JohnsonCook model(parameters, 8930.0);
  for (const double rate : {1e-2, 1.0, 1e3, 1e6}) {
    CopperPoint point(model);
    const double dt = 1e-4 / rate;
    for (int i = 0; i < 200; ++i)
      ASSERT_FALSE(point.apply({0, 0, 0, rate * dt, 0, 0}, dt).failed());
    const double plastic_rate = 2.0 / std::sqrt(3.0) * rate;  // sqrt(2/3 e : e) with e_xy = rate
    const double factor = 1.0 + parameters.c * std::log(std::max(plastic_rate, 1.0));
    EXPECT_NEAR(equivalent(point.stress) / (parameters.a * factor), 1.0, 1e-9) << "rate " << rate;
  }
}

TEST(JohnsonCook, AdiabaticShearFollowsTheExactSoftening) {
  // Perfectly plastic, m = 1: d T* = (chi A (1 - T*) / (rho c (Tm - Tr))) d ep.
  auto parameters = Sample<JohnsonCook>::parameters();
  parameters.b = parameters.c = 0.0;
  parameters.m = 1.0;
  parameters.a = 900e6;
  const JohnsonCook model(parameters, 8930.0);
  const double range = parameters.melt_temperature - parameters.room_temperature;
  const double k =
      parameters.taylor_quinney * parameters.a / (8930.0 * parameters.specific_heat * range);
  std::vector<double> errors;
  for (const int n : {200, 400, 800}) {
    CopperPoint point(model);
    for (int i = 0; i < n; ++i) ASSERT_FALSE(point.apply({0, 0, 0, 2.0 / n, 0, 0}, 1e-8).failed());
    const double homologous = 1.0 - std::exp(-k * point.history.plastic_strain);
    const double t = (point.history.temperature - parameters.room_temperature) / range;
    errors.push_back(std::fabs(t - homologous));
    EXPECT_GT(homologous, 0.3);
  }
  EXPECT_LT(errors[2], 1e-3);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 1.0, 0.15);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 1.0, 0.15);
}

TEST(JohnsonCook, MoltenMetalHasNoDeviator) {
  const auto model = sample_model<JohnsonCook>();
  CopperPoint point(model);
  for (int i = 0; i < 10; ++i) ASSERT_FALSE(point.apply({-1e-3, 0, 0, 1e-3, 0, 0}, 1e-8).failed());
  EXPECT_GT(equivalent(point.stress), model.parameters().a);
  point.history.temperature = model.parameters().melt_temperature * 1.01;
  ASSERT_FALSE(point.apply({-1e-3, 0, 0, 1e-3, 0, 0}, 1e-8).failed());
  EXPECT_LE(equivalent(point.stress), 1e-14 * pressure(point.stress));
  EXPECT_GT(pressure(point.stress), 0.0);
  EXPECT_GT(point.last.plastic_work, 0.0) << "the elastic energy of the old deviator became heat";
}

/// Explicit steps carry strains a cell ahead each time, a millionth of a millionth and less: down
/// to squares that are no longer exact.
TEST(JohnsonCook, WithoutStrengthTheLeastStrainIsNoFailure) {
  auto p = Sample<JohnsonCook>::parameters();
  p.a = p.b = 0.0;
  const JohnsonCook model(p, 880.0);
  for (int power = -330; power <= 0; ++power) {
    const double strain = -0.3 * std::pow(10.0, power);
    Increment increment;
    increment.strain.xx = strain;
    increment.dt = 1e-8;
    increment.volume_ratio_begin = 1.0;
    increment.volume_ratio_end = std::exp(strain);
    Sym3 stress;
    JohnsonCook::History history = model.initial_history();
    EXPECT_EQ(model.update(increment, stress, history).status, Status::ok) << "strain " << strain;
    // What the pressure's own last digit leaves between the components.
    const double round_off = 4.0 * std::numeric_limits<double>::epsilon() * norm(stress);
    EXPECT_LE(equivalent(stress), std::max(round_off, 1e-18)) << "strain " << strain;
  }
}

TEST(JohnsonCook, StrongHeatMelts) {
  const auto model = sample_model<JohnsonCook>();
  CopperPoint point(model);
  for (int i = 0; i < 20000; ++i) ASSERT_FALSE(point.apply({0, 0, 0, 5e-3, 0, 0}, 1e-9).failed());
  // Plastic heat goes to zero with the strength: the melting point is approached, never left
  // behind.
  EXPECT_GT(point.history.temperature, 0.95 * model.parameters().melt_temperature);
  EXPECT_LT(point.history.temperature, 1.01 * model.parameters().melt_temperature);
}

/// Largest normal stress over many directions.
double largest_tension(const Sym3& s) {
  double largest = -HUGE_VAL;
  constexpr int n = 24;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      const double polar = M_PI * i / n, azimuth = M_PI * j / n;
      const double x = std::sin(polar) * std::cos(azimuth), y = std::sin(polar) * std::sin(azimuth);
      const double z = std::cos(polar);
      largest = std::max(
          largest,
          s.xx * x * x + s.yy * y * y + s.zz * z * z +
              2 * (s.xy * x * y + s.yz * y * z + s.zx * z * x)
      );
    }
  }
  return largest;
}

TEST(JohnsonCook, SpallEndsTensionForGood) {
  auto parameters = Sample<JohnsonCook>::parameters();
  parameters.spall_stress = 1.2e9;
  const JohnsonCook model(parameters, 8930.0);
  CopperPoint point(model);
  double strongest = 0.0;
  while (point.history.damage < 1.0 && point.volume_ratio < 1.1) {
    strongest = std::max(strongest, -pressure(point.stress));
    ASSERT_FALSE(point.apply({1e-4, 0, 0, 0, 0, 0}, 1e-9).failed());
  }
  EXPECT_EQ(point.history.damage, 1.0);
  EXPECT_LE(strongest, parameters.spall_stress);
  EXPECT_GT(strongest, 0.98 * parameters.spall_stress) << "one step earlier it still held";
  EXPECT_EQ(largest_tension(point.stress), 0.0);
  // Open further: nothing; close: no load before the void is gone, compression after.
  ASSERT_FALSE(point.apply({2e-2, 0, 0, 0, 0, 0}, 1e-8).failed());
  EXPECT_EQ(norm(point.stress), 0.0);
  while (point.volume_ratio > 1.001) {
    ASSERT_FALSE(point.apply({-1e-4, 0, 0, 0, 0, 0}, 1e-8).failed());
    EXPECT_EQ(norm(point.stress), 0.0) << point.volume_ratio;
  }
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double highest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Sym3 strain{uniform(engine), uniform(engine), uniform(engine), uniform(engine), 0, 0};
    const double drift = point.volume_ratio > 1.0 ? 0.3 : -0.3;  // about the closed state
    ASSERT_FALSE(point.apply(2e-3 * (strain - isotropic(drift)), 1e-8).failed());
    highest = std::max(highest, pressure(point.stress));
    EXPECT_LE(largest_tension(point.stress), 1e-12 * highest);
  }
  EXPECT_GT(highest, 1e8) << "the test must also have seen compression";
}

/// Pulls a point of copper at this temperature apart. @return the largest tension that it bore [Pa]
double largest_tension_at(double temperature) {
  auto parameters = Sample<JohnsonCook>::parameters();
  parameters.spall_stress = 1.2e9;
  parameters.thermal_spall = 1;
  const JohnsonCook model(parameters, 8930.0);
  CopperPoint point(model);
  point.history.temperature = temperature;
  double strongest = 0.0;
  while (point.history.damage < 1.0 && point.volume_ratio < 1.1) {
    strongest = std::max(strongest, -pressure(point.stress));
    EXPECT_FALSE(point.apply(isotropic(1e-6), 1e-9).failed());
  }
  EXPECT_EQ(point.history.damage, 1.0);
  EXPECT_EQ(norm(point.stress), 0.0);
  return strongest;
}

TEST(JohnsonCook, SpallStressFallsToNothingAtMelting) {
  const auto p = Sample<JohnsonCook>::parameters();
  const double range = p.melt_temperature - p.room_temperature;
  // One step of 1e-6 is 0.4 MPa of tension; cooling by expansion adds less than 1 %.
  EXPECT_NEAR(largest_tension_at(p.room_temperature), 1.2e9, 1e6);
  EXPECT_NEAR(largest_tension_at(p.room_temperature + 0.5 * range), 0.6e9, 1e7);
  EXPECT_EQ(largest_tension_at(p.melt_temperature + 100.0), 0.0);
}

TEST(JohnsonCook, DamageBreaksAtTheFractureStrain) {
  auto parameters = linear_hardening();
  parameters.d1 = 0.05;
  parameters.d2 = 0.15;
  parameters.d3 = -3.0;
  parameters.gamma = 0.0;  // no pressure from the plastic heat: sigma* stays 0
  const JohnsonCook model(parameters, 8930.0);
  CopperPoint point(model);
  double last = 0.0;
  while (point.history.damage < 1.0 && point.history.plastic_strain < 1.0) {
    last = point.history.plastic_strain;
    ASSERT_FALSE(point.apply({0, 0, 0, 1e-4, 0, 0}, 1e-8).failed());
  }
  // Pure shear: ef = D1 + D2; damage acts from the step after.
  EXPECT_NEAR(last, 0.2, 2e-4);
  ASSERT_FALSE(point.apply({1e-2, 0, 0, 0, 0, 0}, 1e-8).failed());
  EXPECT_LE(largest_tension(point.stress), 0.0);
}

TEST(JohnsonCook, CompressionBeyondTheHugoniotLimitIsRefused) {
  const auto model = sample_model<JohnsonCook>();
  const double limit = 0.99 / model.parameters().slope;
  CopperPoint point(model);
  for (int i = 0; i < 300; ++i) ASSERT_FALSE(point.apply(isotropic(-1e-3), 1e-9).failed());
  const CopperPoint before = point;
  Increment increment =
      point.increment(isotropic(std::log((1 - limit) / point.volume_ratio) / 3), 1e-9);
  increment.volume_ratio_end = 1.0 - limit;
  EXPECT_EQ(model.update(increment, point.stress, point.history).status, Status::bad_input);
  increment.volume_ratio_end = -0.1;
  EXPECT_EQ(model.update(increment, point.stress, point.history).status, Status::bad_input);
  EXPECT_EQ(std::memcmp(&point.stress, &before.stress, sizeof(Sym3)), 0);
  EXPECT_EQ(std::memcmp(&point.history, &before.history, sizeof(before.history)), 0);
  increment.volume_ratio_end = 1.0 - 0.98 * limit;
  EXPECT_FALSE(model.update(increment, point.stress, point.history).failed());
}

/// Works of a smooth plastic path with viscosity, against the internal energy; relative.
double energy_residual(const JohnsonCook& model, int n) {
  CopperPoint point(model);
  point.history.plastic_strain = 0.2;  // at 0 the hardening rate is infinite
  const double total = 0.1;
  double works = 0.0;
  for (int i = 0; i < n; ++i) {
    const double angle = 0.7 * (i + 0.5) / n, size = total / n;
    const double c = size * std::cos(angle), s = size * std::sin(angle);
    const Sym3 strain = Sym3{-c, c, 0, s, 0, 0} - isotropic(0.3 * size);
    const double v = point.volume_ratio;
    EXPECT_FALSE(point.apply(strain, 1e-6 / n, 2e9).failed());
    works += point.last.elastic_work + point.last.plastic_work - 2e9 * (point.volume_ratio - v);
  }
  const double energy = point.history.internal_energy * model.equation_of_state().density;
  return std::fabs(works - energy) / energy;
}

TEST(JohnsonCook, WorksAddUpToTheInternalEnergy) {
  const auto model = sample_model<JohnsonCook>();
  // What is left comes from the one step in which the point begins to yield.
  const double coarse = energy_residual(model, 50), fine = energy_residual(model, 800);
  EXPECT_LT(coarse, 5e-5);
  EXPECT_GT(std::log2(coarse / fine) / 4.0, 1.7);
}

/// The root lies where residual changes sign within the promised accuracy.
TEST(JohnsonCookFlow, ReturnSolvesTheFlowStress) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  int plastic = 0;
  for (int k = 0; k < 100000; ++k) {
    const JohnsonCookFlow flow{
        1e9 * u(engine),
        1e9 * u(engine),
        0.1 * u(engine),
        0.05 + 1.2 * u(engine),
        0.5 + u(engine),
        1.0,
        294.0,
        1e-3,
        4.5e11 * (0.1 + u(engine))};
    const double temperature = 250.0 + 1000.0 * u(engine);
    const double ep = u(engine) < 0.2 ? 0.0 : std::pow(10.0, -8.0 * u(engine));
    const double still = flow.stress(ep, 0.0, temperature);
    EXPECT_LE(flow.lower_bound(ep, temperature), still * (1.0 + 1e-14));
    const double trial = still * (1.0 + std::pow(10.0, 1.0 - 14.0 * u(engine)));
    const double dt = u(engine) < 0.1 ? 0.0 : std::pow(10.0, -4.0 - 8.0 * u(engine));
    const double scale = metal::rate_scale(dt, flow.reference_rate);
    const metal::ReturnProblemOf<double> problem{trial, 1.1 * still * u(engine), scale, ep};
    metal::ReturnSearchOf<JohnsonCookFlow, double> search;
    metal::search_return(flow, temperature, problem, search);
    const auto result = metal::end_return(flow, problem, search);
    ASSERT_TRUE(result.converged);
    const double x = result.plastic_increment;
    if (x == 0.0) continue;
    ++plastic;
    const auto residual = [&](double y) {
      const double rate = dt > 0.0 ? y / dt : 0.0;
      return trial - flow.stiffness * y - flow.stress(ep + y, rate, temperature);
    };
    const double accuracy = 1e-9 * x + 1e-10 * trial / flow.stiffness;  // as promised there
    EXPECT_GE(residual(std::max(0.0, x - accuracy)), -1e-14 * trial);
    EXPECT_LE(residual(x + accuracy), 1e-14 * trial);
    EXPECT_GE(result.mean_stress, 0.0);
  }
  EXPECT_GT(plastic, 50000);
}

TEST(JohnsonCook, ReferenceStrainRateAndTaylorQuinneyDefaultsAreTheTables) {
  const JohnsonCook::Parameters defaults;
  for (const auto& entry : JohnsonCook::parameter_table().numbers) {
    if (!entry.required) {
      EXPECT_EQ(defaults.*entry.member, entry.default_value) << entry.name;
    }
  }
}

}  // namespace
}  // namespace barreno::test
