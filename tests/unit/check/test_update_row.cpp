// SPDX-License-Identifier: BSD-3-Clause
#include "check/update_row.hpp"

#include <gtest/gtest.h>

#include <barreno/registry.hpp>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace barreno {
namespace {

/// Rows of the table whose verb is this one, whichever law of the form they are for.
int rows_of_verb(const std::string& verb) {
  int count = 0;
  for (const auto& [row, cost] : cost_tables().updates) {
    if (row == verb || row.rfind(verb + ", ", 0) == 0) ++count;
  }
  return count;
}

template <std::size_t... I>
std::vector<std::string> verbs_of(std::index_sequence<I...>) {
  return {"update_stress " + FullName<std::variant_alternative_t<I, AnyModel>>::of()...};
}

TEST(UpdateRow, EveryFormHasOne) {
  for (const std::string& verb :
       verbs_of(std::make_index_sequence<std::variant_size_v<AnyModel>>{}))
    EXPECT_GE(rows_of_verb(verb), 1) << verb;
}

TEST(UpdateRow, NoneCostsNothing) {
  EXPECT_EQ(cost_tables().problem, "");
  EXPECT_GT(cost_tables().updates.size(), 10U);
  for (const auto& [row, cost] : cost_tables().updates) {
    EXPECT_GT(cost.elastic, 0.0) << row;
    EXPECT_GE(cost.running, cost.elastic) << row;
  }
}

Teuchos::ParameterList sandstone() {
  std::ifstream file(BARRENO_SOURCE_DIR "/materials/cards/berea_sandstone.xml");
  std::ostringstream text;
  text << file.rdbuf();
  return scan_card(text.str(), "berea_sandstone.xml");
}

std::string growing_row(const Teuchos::ParameterList& card) {
  const Material rock = make_material("sandstone", card);
  const std::optional<UpdateCost> cost = update_cost(rock);
  EXPECT_TRUE(cost && cost->running > cost->elastic) << update_row(rock);
  return update_row(rock);
}

TEST(UpdateRow, EveryFeatureOfRockHasItsOwn) {
  const std::string plain = "update_stress Arenisca", rated = "update_stress Arenisca rated",
                    all = "update_stress Arenisca rated heated",
                    angled = "update_stress Arenisca angled";
  for (const double fluid : {0.0, 2.2e9}) {
    Teuchos::ParameterList card = sandstone();
    card.set("fluid_B0", fluid);
    const std::string wet = fluid > 0.0 ? " wet" : "";
    EXPECT_EQ(growing_row(card), plain + wet);
    card.set("T1_rate_dependence", 1e-5);
    card.set("T2_rate_dependence", 0.3);
    EXPECT_EQ(growing_row(card), rated + wet);
    Teuchos::ParameterList breaking = card;
    breaking.set("FSLOPE", 0.54);  // broken rock has none of its strength without pressure
    breaking.set("Fracture strain", 0.03);
    EXPECT_EQ(growing_row(breaking), all + wet);
    breaking.set("Specific heat", 1000.0);
    EXPECT_EQ(growing_row(breaking), all + wet);
    for (const char* third : {"Gudehus", "Willam-Warnke", "Mohr-Coulomb"}) {
      card.set("J3_type", std::string(third));
      card.set("J3_psi", 0.8);
      EXPECT_EQ(growing_row(card), angled + wet);
    }
  }
}

TEST(UpdateRow, LawsOfTheGeneralFormHaveOneEach) {
  const std::string verb = "update_stress Arenisca general, ";
  Teuchos::ParameterList card = sandstone();
  card.set("Return solver", std::string("bisection"));
  EXPECT_EQ(growing_row(card), verb + "bisection");
  card = sandstone();
  card.set("fluid_B0", 2.2e9);
  card.set("Backstress strain", std::string("elastic centre"));
  EXPECT_EQ(growing_row(card), verb + "elastic centre");
  card.set("Backstress strain", std::string("plastic"));
  EXPECT_EQ(growing_row(card), verb + "plastic");
  card.set("Undrained moduli", std::string("arenisca3"));
  EXPECT_EQ(growing_row(card), verb + "arenisca3");
}

}  // namespace
}  // namespace barreno
