// SPDX-License-Identifier: BSD-3-Clause
/// The C interface does what the models do, in its own order of components, and refuses what it
/// must.

#include "general_card.hpp"

#include <gtest/gtest.h>

#include <barreno/history_values.hpp>
#include <barreno/models.hpp>
#include <barreno/registry.hpp>
#include <barreno/tangent.hpp>
#include <barreno_material.h>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

const std::string cards = std::string(BARRENO_SOURCE_DIR) + "/materials/cards/";
const std::vector<std::string> card_names = {
    "aluminium_6061_t6",
    "arenisca_demonstration",
    "berea_sandstone",
    "copper",
    "steel_4340",
    "tungsten",
    "water"};
/// Their form has one state variable more, the strain of the voids.
const std::vector<std::string> voided_card_names = {
    "aluminium_6061_fracture", "copper_ofhc", "steel_4340_fracture", "tungsten_alloy"};

struct Opened {
  explicit Opened(const std::string& card) : m(barreno_material_open(card.c_str())) {}
  ~Opened() { barreno_material_close(m); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  barreno_material* m;
};

/// Arrays of a batch.
struct Arrays {
  int count, states;
  std::vector<double> strain, stress_old, stress_new, state_old, state_new, tangent, work;
  std::vector<int> status;
  Arrays(int n, const barreno_material* m)
      : count(n),
        states(barreno_material_state_count(m)),
        strain(size(6)),
        stress_old(size(6)),
        stress_new(size(6)),
        state_old(size(states)),
        state_new(size(states)),
        tangent(size(36)),
        work(size(2)),
        status(size(1)) {}
  std::size_t size(int each) const {
    return static_cast<std::size_t>(count) * static_cast<std::size_t>(each);
  }
  barreno_batch batch(int want, double dt) {
    return {
        count,
        want,
        dt,
        strain.data(),
        stress_old.data(),
        stress_new.data(),
        state_old.data(),
        state_new.data(),
        tangent.data(),
        work.data(),
        status.data()};
  }
  void accept() {
    stress_old = stress_new;
    state_old = state_new;
  }
};

std::string error() {
  return barreno_last_error();
}

TEST(CInterface, OpensEveryCardAndDescribesItsState) {
  EXPECT_EQ(barreno_abi_version(), BARRENO_ABI_VERSION);
  for (const std::string& name : card_names) {
    const Opened card(cards + name + ".xml");
    ASSERT_NE(card.m, nullptr) << error();
    const Material material = read_card(cards + name + ".xml");
    EXPECT_EQ(barreno_material_density(card.m), material.density);
    const ModelDescription& model = find_model(barreno_material_model(card.m));
    const int count = barreno_material_state_count(card.m);
    ASSERT_EQ(count, 2 + static_cast<int>(model.history.size()));
    EXPECT_STREQ(barreno_material_state_name(card.m, 0), "initialized");
    EXPECT_STREQ(barreno_material_state_name(card.m, 1), "volume_ratio");
    for (int i = 2; i < count; ++i) {
      const HistoryField& field = model.history[static_cast<std::size_t>(i - 2)];
      EXPECT_STREQ(barreno_material_state_name(card.m, i), field.name);
      EXPECT_STREQ(barreno_material_state_meaning(card.m, i), field.meaning);
    }
    EXPECT_EQ(barreno_material_state_name(card.m, count), nullptr);
    EXPECT_EQ(barreno_material_state_name(card.m, -1), nullptr);
  }
  const Opened copper(cards + "copper.xml");
  EXPECT_STREQ(barreno_material_state_name(copper.m, 3), "temperature");
  EXPECT_STREQ(barreno_material_state_unit(copper.m, 3), "K");
  EXPECT_EQ(barreno_material_state_initial(copper.m, 3), 294.0);
}

TEST(CInterface, OpensMetalsThatFailWithTheStrainOfTheirVoids) {
  for (const std::string& name : voided_card_names) {
    const Opened card(cards + name + ".xml");
    ASSERT_NE(card.m, nullptr) << error();
    EXPECT_STREQ(barreno_material_model(card.m), "Johnson-Cook");
    ASSERT_EQ(barreno_material_state_count(card.m), 7) << name;
    EXPECT_STREQ(barreno_material_state_name(card.m, 6), "expansion_strain");
  }
}

TEST(CInterface, FindsCardsByNameInAnyCase) {
  for (const char* name : {"BEREA_SANDSTONE", "berea_sandstone.xml", "Berea_Sandstone.XML"}) {
    const Opened card(name);
    ASSERT_NE(card.m, nullptr) << error();
    EXPECT_NE(
        std::string(barreno_material_file(card.m)).find("berea_sandstone.xml"), std::string::npos
    );
  }
  const std::string folder = ::testing::TempDir() + "barreno_cards";
  ASSERT_EQ(std::system(("mkdir -p " + folder).c_str()), 0);
  std::ofstream(folder + "/COPPER.xml") << std::ifstream(cards + "tungsten.xml").rdbuf();
  setenv("BARRENO_MATERIALS", ("/nowhere:" + folder).c_str(), 1);
  const Opened own("copper");
  unsetenv("BARRENO_MATERIALS");
  ASSERT_NE(own.m, nullptr) << error();
  EXPECT_EQ(barreno_material_file(own.m), folder + "/COPPER.xml") << "BARRENO_MATERIALS goes first";
}

TEST(CInterface, RefusesCardsInOneSentence) {
  const auto refusal = [](const char* card) {
    EXPECT_EQ(barreno_material_open(card), nullptr);
    return error();
  };
  EXPECT_NE(refusal(nullptr).find("no card is named"), std::string::npos);
  EXPECT_NE(refusal("").find("no card is named"), std::string::npos);
  EXPECT_NE(refusal("coper").find("did you mean 'copper'?"), std::string::npos);
  const std::string file = ::testing::TempDir() + "bad_card.xml";
  std::ofstream(file
  ) << "<ParameterList><Parameter name=\"Model\" value=\"Areniska\"/></ParameterList>";
  EXPECT_NE(refusal(file.c_str()).find("did you mean 'Arenisca'?"), std::string::npos) << error();
  std::ofstream(file) << "rubbish";
  EXPECT_FALSE(refusal(file.c_str()).empty());
  EXPECT_FALSE(refusal(cards.c_str()).empty()) << "a folder is no card";
}

/// Random steps through the interface and through the model itself.
template <class Model>
void compare(const barreno_material* m, const Model& model, double pressure = 0.0) {
  // 11 22 33 12 13 23 against xx yy zz xy yz zx.
  constexpr int place[6] = {0, 1, 2, 3, 5, 4};
  std::mt19937 engine(1);
  std::normal_distribution<double> normal(0.0, 1e-3);
  Arrays a(1, m);
  const auto start = model.initial_state(pressure);
  Sym3 stress = start.stress;
  auto history = start.history;
  double ratio = start.volume_ratio;
  for (std::size_t i = 0; i < 3; ++i) a.stress_old[i] = -pressure;
  constexpr double dt = 1e-6;
  for (int step = 0; step < 30; ++step) {
    Increment increment{};
    for (int i = 0; i < 6; ++i) {
      const double strain = normal(engine);
      tangent::components(increment.strain)[i] = strain;
      a.strain[static_cast<std::size_t>(place[i])] = strain;
    }
    increment.dt = dt;
    increment.volume_ratio_begin = ratio;
    increment.volume_ratio_end = ratio *= std::exp(trace(increment.strain));
    Tangent tangent;
    const Outcome outcome = update_with_tangent(model, increment, stress, history, tangent);
    ASSERT_FALSE(outcome.failed());
    const barreno_batch batch = a.batch(BARRENO_CONSISTENT, dt);
    ASSERT_EQ(barreno_material_update(m, &batch), 0) << error();
    ASSERT_EQ(a.status[0], BARRENO_OK);
    for (int i = 0; i < 6; ++i) {
      const auto p = static_cast<std::size_t>(place[i]);
      EXPECT_EQ(a.stress_new[p], tangent::components(stress)[i]);
      for (int j = 0; j < 6; ++j)
        EXPECT_EQ(a.tangent[6 * p + static_cast<std::size_t>(place[j])], tangent.c[i][j]);
    }
    EXPECT_EQ(a.work[0], outcome.elastic_work);
    EXPECT_EQ(a.work[1], outcome.plastic_work);
    EXPECT_EQ(a.state_new[0], 1.0);
    EXPECT_EQ(a.state_new[1], ratio);
    for (int i = 0; i < Model::history_count; ++i) {
      EXPECT_EQ(a.state_new[static_cast<std::size_t>(2 + i)], history_values<Model>(history)[i]);
    }
    const double modulus =
        barreno_material_longitudinal_modulus(m, a.stress_new.data(), a.state_new.data());
    EXPECT_EQ(modulus, model.longitudinal_modulus(stress, history, ratio));
    a.accept();
  }
}

TEST(CInterface, DoesWhatTheModelDoes) {
  std::vector<std::string> names = card_names;
  names.insert(names.end(), voided_card_names.begin(), voided_card_names.end());
  for (const std::string& name : names) {
    const Opened card(cards + name + ".xml");
    ASSERT_NE(card.m, nullptr) << error();
    const Material material = read_card(cards + name + ".xml");
    std::visit([&](const auto& model) { compare(card.m, model); }, material.model);
  }
}

/// The registry takes another form where a card asks for what only that has; the host sees its
/// history, and the same bits.
template <class Form>
void compare_form(const std::string& more) {
  SCOPED_TRACE(FullName<Form>::of());
  const std::string file = berea_card_with(more, "general_c_interface");
  const Opened card(file);
  ASSERT_NE(card.m, nullptr) << error();
  EXPECT_STREQ(barreno_material_model(card.m), "Arenisca");
  const auto history = Form::history_table();
  ASSERT_EQ(barreno_material_state_count(card.m), 2 + static_cast<int>(history.size()));
  for (int i = 0; i < static_cast<int>(history.size()); ++i) {
    EXPECT_STREQ(
        barreno_material_state_name(card.m, 2 + i), history[static_cast<std::size_t>(i)].name
    );
  }
  const Material material = read_card(file);
  ASSERT_TRUE(std::holds_alternative<Form>(material.model));
  const auto& model = std::get<Form>(material.model);
  double pressure = 0.0;
  if constexpr (is_drainable<Form>) pressure = model.virgin_pressure();
  compare(card.m, model, pressure);
}

TEST(CInterface, DoesWhatEveryFormOfAreniscaDoes) {
  compare_form<WetArenisca>(water_in_quartz);
  compare_form<RatedWetArenisca>(water_in_quartz + overstress);
  compare_form<AngledWetArenisca>(everything_general);
  compare_form<ScatteredArenisca>(scatter);
  compare_form<RatedArenisca>(overstress);
  compare_form<AngledArenisca>(third_invariant);
  compare_form<AngledArenisca>(third_invariant + overstress + scatter);
  compare_form<GeneralArenisca>(by_bisection);
  compare_form<GeneralArenisca>(water_in_quartz + about_the_elastic_centre);
  compare_form<GeneralArenisca>(everything_general + about_the_elastic_centre);
}

TEST(CInterface, AStepMayBeTriedAgainAndInPlace) {
  const Opened card(cards + "berea_sandstone.xml");
  Arrays a(2, card.m);
  a.strain[0] = a.strain[8] = -5e-3;
  barreno_batch batch = a.batch(BARRENO_STRESS, 1.0);
  ASSERT_EQ(barreno_material_update(card.m, &batch), 0);
  const auto first = a.stress_new;
  ASSERT_EQ(barreno_material_update(card.m, &batch), 0);
  EXPECT_EQ(a.stress_new, first);
  batch.stress_new = a.stress_old.data();
  batch.state_new = a.state_old.data();
  batch.tangent = nullptr;
  batch.work = nullptr;
  batch.status = nullptr;
  ASSERT_EQ(barreno_material_update(card.m, &batch), 0);
  EXPECT_EQ(a.stress_old, first);
}

/// A confined start: the host gives the pressure only, the state stays zero.
TEST(CInterface, VirginPointsUnderPressureAreInEquilibrium) {
  std::vector<std::string> files{berea_card_with(everything_general, "general_confined")};
  for (const auto* names : {&card_names, &voided_card_names})
    for (const std::string& name : *names) files.push_back(cards + name + ".xml");
  for (const std::string& file : files) {
    const Opened card(file);
    ASSERT_NE(card.m, nullptr) << error();
    Arrays a(1, card.m);
    constexpr double pressure = 20e6;
    for (std::size_t i = 0; i < 3; ++i) a.stress_old[i] = -pressure;
    const barreno_batch batch = a.batch(BARRENO_CONSISTENT, 1e-6);
    ASSERT_EQ(barreno_material_update(card.m, &batch), 0) << error();
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.stress_new[i], -pressure, 1e-9 * pressure);
    EXPECT_EQ(a.work[1], 0.0);
  }
}

/// Pores under pressure and no stress at all: said, not computed.
TEST(CInterface, PoresUnderPressureNeedAnInitialStress) {
  const Opened card(berea_card_with(everything_general, "general_unstressed"));
  ASSERT_NE(card.m, nullptr) << error();
  Arrays a(1, card.m);
  const barreno_batch batch = a.batch(BARRENO_CONSISTENT, 1e-6);
  EXPECT_EQ(barreno_material_update(card.m, &batch), 1);
  EXPECT_EQ(a.status[0], BARRENO_BAD_INPUT);
  EXPECT_NE(
      error().find("starts unstressed, but the card's fluid_pressure_initial = 1.5e+07"),
      std::string::npos
  ) << error();
  EXPECT_EQ(a.stress_new[0], 0.0);
  EXPECT_GT(a.tangent[0], 0.0);
  const auto modulus = [&] {
    return barreno_material_longitudinal_modulus(card.m, a.stress_old.data(), a.state_old.data());
  };
  EXPECT_EQ(modulus(), 0.0) << "an impossible step or state";
  for (std::size_t i = 0; i < 3; ++i) a.stress_old[i] = -15e6;
  EXPECT_EQ(barreno_material_update(card.m, &batch), 0) << error();
  EXPECT_GT(modulus(), 0.0);
}

TEST(CInterface, FailedPointsKeepWhatTheyHad) {
  const Opened card(cards + "berea_sandstone.xml");
  Arrays a(5, card.m);
  const auto states = static_cast<std::size_t>(a.states);
  for (std::size_t p = 0; p < 5; ++p) {
    a.strain[6 * p] = -1e-3;
    a.stress_old[6 * p + 1] = -1e6;
    a.state_old[states * p] = a.state_old[states * p + 1] = 1.0;
  }
  a.strain[6 * 1 + 2] = std::nan("");  // point 1: strain
  a.strain[6 * 2 + 2] = -50.0;         // point 2: absurd strain
  a.stress_old[6 * 3] = HUGE_VAL;      // point 3: stress
  a.state_old[states * 4 + 1] = -1.0;  // point 4: volume ratio
  const barreno_batch batch = a.batch(BARRENO_CONSISTENT, 1.0);
  EXPECT_EQ(barreno_material_update(card.m, &batch), 4);
  EXPECT_EQ(a.status, (std::vector<int>{0, 3, 3, 3, 3}));
  EXPECT_NE(error().find("point 1 of the batch"), std::string::npos) << error();
  for (std::size_t p = 1; p < 5; ++p) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double old = a.stress_old[6 * p + i];
      EXPECT_EQ(a.stress_new[6 * p + i], std::isfinite(old) ? old : 0.0);
    }
    for (std::size_t i = 0; i < states; ++i)
      EXPECT_EQ(a.state_new[states * p + i], a.state_old[states * p + i]);
    EXPECT_GT(a.tangent[36 * p], 1e9) << "the elastic tangent";
    EXPECT_EQ(a.work[2 * p], 0.0);
  }
  for (const double t : a.tangent) EXPECT_TRUE(std::isfinite(t));
}

TEST(CInterface, CallsThatCannotBeServedSayWhy) {
  const Opened card(cards + "copper.xml");
  Arrays a(1, card.m);
  a.stress_new[0] = 42.0;
  const barreno_batch good = a.batch(BARRENO_CONSISTENT, 1.0);
  const auto refuses = [&](const barreno_material* m, const barreno_batch* b, const char* why) {
    EXPECT_EQ(barreno_material_update(m, b), -1);
    EXPECT_NE(error().find(why), std::string::npos) << error();
    EXPECT_EQ(a.stress_new[0], 42.0) << "nothing is written";
  };
  refuses(nullptr, &good, "NULL");
  refuses(card.m, nullptr, "NULL");
  barreno_batch b = good;
  b.count = -3;
  refuses(card.m, &b, "-3 points");
  b = good;
  b.want = 7;
  refuses(card.m, &b, "want = 7");
  b = good;
  b.tangent = nullptr;
  refuses(card.m, &b, "tangent");
  for (double* barreno_batch::*member : {&barreno_batch::stress_new, &barreno_batch::state_new}) {
    b = good;
    b.*member = nullptr;
    refuses(card.m, &b, "an array of the batch is NULL");
  }
  b = barreno_batch{};
  EXPECT_EQ(barreno_material_update(card.m, &b), 0) << "no points, nothing to do";
}

}  // namespace
}  // namespace barreno::test
