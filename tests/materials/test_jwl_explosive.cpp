// SPDX-License-Identifier: BSD-3-Clause
/// JWL Explosive against states that are known independently: Chapman-Jouguet, isentropes, sound
/// speed, expansion of a point, energy of a point that burns.

#include "barreno/find_card.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace barreno::test {
namespace {

struct CardStates {
  const char* card;
  double v_cj, p_cj, speed;  ///< Chapman-Jouguet state
};

/// Found with a solver of its own from the numbers on the cards, to all digits given.
const std::vector<CardStates> card_states{
    {"comp_b", 0.73020, 29.500e9, 7980.0},
    {"tnt", 0.73169, 21.000e9, 6929.4},
    {"c_4", 0.73946, 28.000e9, 8193.0},
    {"pbx_9404", 0.74033, 37.001e9, 8800.1},
    {"lx_10", 0.74090, 37.498e9, 8820.9}};

JwlExplosive explosive_of(const std::string& card) {
  const Material material = material_open(card);
  return std::get<JwlExplosive>(material.model);
}

TEST(JwlExplosive, ChapmanJouguetStatesOfTheCards) {
  for (const CardStates& of : card_states) {
    const auto state = explosive_of(of.card).products().chapman_jouguet();
    ASSERT_TRUE(state.found) << of.card;
    EXPECT_NEAR(state.volume_ratio / of.v_cj, 1.0, 1e-4) << of.card;
    EXPECT_NEAR(state.pressure / of.p_cj, 1.0, 1e-4) << of.card;
    EXPECT_NEAR(state.speed / of.speed, 1.0, 1e-4) << of.card;
  }
}

/// gamma = 3: v = 3/4, p = rho0 D^2 / 4.
TEST(JwlExplosive, ChapmanJouguetStateOfAGammaLaw) {
  const double density = 1600.0, speed = 8000.0, gamma = 3.0;
  const JwlProducts gas{
      density, 0.0, 0.0, 1.0, 1.0, gamma - 1.0, density * speed * speed / (2.0 * 8.0)};
  const auto state = gas.chapman_jouguet();
  ASSERT_TRUE(state.found);
  EXPECT_NEAR(state.volume_ratio, 0.75, 1e-12);
  EXPECT_NEAR(state.pressure / (0.25 * density * speed * speed), 1.0, 1e-12);
  EXPECT_NEAR(state.speed / speed, 1.0, 1e-12);
}

/// rho c^2 against the difference of pressures along dE = -p dv.
TEST(JwlExplosive, ModulusIsTheSlopeOfTheIsentrope) {
  for (const CardStates& of : card_states) {
    const JwlProducts gas = explosive_of(of.card).products();
    for (const double v : {0.6, 0.75, 1.0, 2.0, 7.0, 40.0}) {
      const double e = gas.energy * std::pow(v, -gas.omega), p = gas.pressure(v, e);
      const double h = 1e-4 * v;
      // To third order: d2E/dv2 = -(dp/dv)_s, which the modulus itself would give, cancels in the
      // central difference.
      const auto along = [&](double x) {
        const double slope = -gas.isentropic_modulus(v, e) / v;
        return gas.pressure(v + x, e - p * x - 0.5 * slope * x * x);
      };
      const double difference = -v * (along(h) - along(-h)) / (2.0 * h);
      EXPECT_NEAR(gas.isentropic_modulus(v, e) / difference, 1.0, 1e-6) << of.card << " v " << v;
    }
  }
}

/// Products on the isentrope through the Chapman-Jouguet state:
/// p = A exp(-R1 v) + B exp(-R2 v) + C v^(-1-w).
struct Isentrope {
  JwlProducts gas;
  double v_cj, c;
  explicit Isentrope(const JwlProducts& of) : gas(of) {
    const auto state = gas.chapman_jouguet();
    v_cj = state.volume_ratio;
    c = (state.pressure - gas.a * std::exp(-gas.r1 * v_cj) - gas.b * std::exp(-gas.r2 * v_cj)) *
        std::pow(v_cj, 1.0 + gas.omega);
  }
  double pressure(double v) const {
    return gas.a * std::exp(-gas.r1 * v) + gas.b * std::exp(-gas.r2 * v) +
           c * std::pow(v, -1.0 - gas.omega);
  }
  double energy(double v) const {
    return gas.a / gas.r1 * std::exp(-gas.r1 * v) + gas.b / gas.r2 * std::exp(-gas.r2 * v) +
           c / gas.omega * std::pow(v, -gas.omega);
  }
};

TEST(JwlExplosive, IsentropesOfCompositionBAndC4) {
  const std::vector<double> volumes{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0};
  const std::vector<double> comp_b{11.50, 3.066, 1.396, 0.5332, 0.2631, 0.1566, 0.08323, 0.04958};
  const std::vector<double> c_4{11.01, 2.928, 1.301, 0.4593, 0.2323, 0.1514, 0.09235, 0.05868};
  const Isentrope first(explosive_of("comp_b").products());
  const Isentrope second(explosive_of("c_4").products());
  for (std::size_t i = 0; i < volumes.size(); ++i) {  // four digits are given
    EXPECT_NEAR(first.pressure(volumes[i]) / (1e9 * comp_b[i]), 1.0, 5e-4) << volumes[i];
    EXPECT_NEAR(second.pressure(volumes[i]) / (1e9 * c_4[i]), 1.0, 5e-4) << volumes[i];
  }
}

/// A burnt point at the Chapman-Jouguet state that expands to v = 7 in `steps` steps.
/// @return error of its energy, over E0
double expansion_error(const JwlExplosive& model, int steps) {
  const Isentrope exact(model.products());
  Sym3 stress = isotropic(-exact.pressure(exact.v_cj));
  JwlExplosive::History history{0.0, 1.0, exact.energy(exact.v_cj) / model.products().density};
  const double strain = std::log(7.0 / exact.v_cj) / steps;
  double v = exact.v_cj;
  for (int i = 0; i < steps; ++i) {
    Increment increment{};
    increment.strain = isotropic(strain / 3.0);
    increment.dt = 1e-9;
    increment.volume_ratio_begin = v;
    increment.volume_ratio_end = v *= std::exp(strain);
    EXPECT_FALSE(model.update(increment, stress, history).failed());
  }
  const double energy = history.internal_energy * model.products().density;
  return std::fabs(energy - exact.energy(7.0)) / model.products().energy;
}

TEST(JwlExplosive, ExpansionFollowsTheIsentropeAtSecondOrder) {
  for (const CardStates& of : card_states) {
    const JwlExplosive model = explosive_of(of.card);
    const double coarse = expansion_error(model, 100), fine = expansion_error(model, 200);
    EXPECT_LT(coarse, 1e-3) << of.card;
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05) << of.card;
  }
}

TEST(JwlExplosive, BurnsAcrossItsWidthAndNeverBack) {
  const auto model = sample_model<JwlExplosive>();
  const double cell = 1e-3, speed = model.parameters().detonation_speed;
  const double whole = model.parameters().burn_width * cell / speed;  // time to burn [s]
  JwlExplosive::History history{2e-6, 0.0, 0.0};
  const auto burnt_at = [&](double time) {
    model.burn(time, cell, history);
    return history.burn;
  };
  EXPECT_EQ(burnt_at(1e-6), 0.0);
  EXPECT_EQ(burnt_at(2e-6 + 0.9e-4 * whole), 0.0);  // below 1e-4
  EXPECT_NEAR(burnt_at(2e-6 + 0.25 * whole), 0.25, 1e-12);
  EXPECT_NEAR(burnt_at(2e-6 + 0.20 * whole), 0.25, 1e-12);  // a coarser cell, say
  EXPECT_EQ(burnt_at(2e-6 + 1.5 * whole), 1.0);
}

TEST(JwlExplosive, NamesTheColumnsOfItsProgram) {
  const auto table = JwlExplosive::history_table();
  EXPECT_STREQ(table[JwlExplosive::lighting_column].name, "lighting_time");
  EXPECT_STREQ(table[JwlExplosive::burn_column].name, "burn");
}

/// What a point gives while it burns and expands is what its energy loses, viscous heat included.
TEST(JwlExplosive, EnergyIsTheWorkOfThePoint) {
  const JwlExplosive model = explosive_of("comp_b");
  const double density = model.products().density;
  Sym3 stress{};
  JwlExplosive::History history = model.initial_history();
  const double begin = history.internal_energy;
  double v = 1.0, work = 0.0;
  for (int i = 0; i < 400; ++i) {
    model.burn(1e-8 * i, 1e-3, history);
    const double change = i < 30 ? -0.008 : 0.01;
    const double viscous = i < 30 ? 2e9 : 0.0;
    Increment increment{};
    increment.strain = isotropic(std::log(1.0 + change / v) / 3.0);
    increment.dt = 1e-8;
    increment.viscous_pressure = viscous;
    increment.volume_ratio_begin = v;
    increment.volume_ratio_end = v += change;
    const Outcome outcome = model.update(increment, stress, history);
    ASSERT_FALSE(outcome.failed());
    EXPECT_EQ(outcome.plastic_work, 0.0);
    EXPECT_EQ(stress.xy, 0.0);
    EXPECT_EQ(stress.xx, stress.zz);
    work += outcome.elastic_work - viscous * change;
  }
  EXPECT_NEAR(density * (history.internal_energy - begin), work, 1e-12 * density * begin);
  EXPECT_LT(work, -0.2 * density * begin);
}

/// Ahead of the front the step must be as short as behind it, and an unlit point bears nothing.
TEST(JwlExplosive, UnlitExplosiveIsAsFastAsTheFront) {
  const JwlExplosive model = explosive_of("comp_b");
  const double density = model.products().density;
  const auto start = model.initial_state(0.0);
  const double modulus = model.longitudinal_modulus(start.stress, start.history, 1.0);
  EXPECT_NEAR(std::sqrt(modulus / density), 7980.0, 1e-9);
  EXPECT_FALSE(model.initial_state(1e6).possible);  // without an Unreacted Bulk Modulus
  Sym3 stress{};
  JwlExplosive::History history = start.history;
  Increment squeeze{};
  squeeze.strain = isotropic(-1e-3);
  squeeze.volume_ratio_end = std::exp(-3e-3);
  ASSERT_FALSE(model.update(squeeze, stress, history).failed());
  EXPECT_EQ(largest_component(stress), 0.0);
}

/// The set that some codes print for PBX-9404.
TEST(JwlExplosive, RefusesASetThatContradictsItsSpeed) {
  auto p = explosive_of("pbx_9404").parameters();
  EXPECT_EQ(JwlExplosive::check(p, 1840.0), "");
  p.r1 = 4.55;
  EXPECT_NE(
      JwlExplosive::check(p, 1840.0).find("contradicts the equation of state"), std::string::npos
  );
}

}  // namespace
}  // namespace barreno::test
