// SPDX-License-Identifier: BSD-3-Clause
#include "rock_forms.hpp"

#include <barreno/registry.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace barreno {
namespace {

using Values = std::vector<CardValue>;

Values operator+(Values a, const Values& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Values third_invariant(const char* kind) {
  return {{"J3_type", 0.0, kind}, {"J3_psi", 0.8}};
}

}  // namespace

std::vector<RockForm> rock_forms() {
  const Values water = {{"fluid_B0", 2.2e9}};
  const Values scatter = {{"Weibull modulus", 8.0}, {"Weibull reference volume", 1e-6}};
  const Values rate = {{"T1_rate_dependence", 1e-5}, {"T2_rate_dependence", 0.3}};
  const Values bisection = {{"Return solver", 0.0, "bisection"}};
  const Values centre = {{"Backstress strain", 0.0, "elastic centre"}};
  const Values plastic = {{"Backstress strain", 0.0, "plastic"}};
  const Values arenisca3 = {{"Undrained moduli", 0.0, "arenisca3"}};
  const std::vector<std::pair<std::string, Values>> features = {
      {"plain", {}},
      {"scatter", scatter},
      {"rate", rate},
      {"Gudehus", third_invariant("Gudehus")},
      {"Willam-Warnke", third_invariant("Willam-Warnke")},
      {"Mohr-Coulomb", third_invariant("Mohr-Coulomb")},
      {"all", third_invariant("Willam-Warnke") + rate + scatter}};
  std::vector<RockForm> forms;
  for (const bool wet : {false, true})
    for (const auto& feature : features)
      forms.push_back(
          {std::string(wet ? "wet" : "dry") + ", " + feature.first,
           wet,
           (wet ? water : Values{}) + feature.second}
      );
  forms.push_back({"dry, bisection", false, bisection});
  forms.push_back({"wet, elastic centre", true, water + centre});
  forms.push_back({"wet, plastic", true, water + plastic});
  forms.push_back({"wet, plastic, arenisca3", true, water + plastic + arenisca3});
  return forms;
}

Material make_form(const std::string& card, const RockForm& form, double tolerance) {
  std::ifstream in(card);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error("cannot read '" + card + "'; give the card of a dry rock.");
  Teuchos::ParameterList list = scan_card(text.str(), card);
  for (const CardValue& value : form.values) {
    if (value.word != nullptr)
      list.set(value.name, std::string(value.word));
    else
      list.set(value.name, value.number);
  }
  list.set("Tolerance", tolerance);
  return make_material(form.name, list, card);
}

std::string words_of(const RockForm& form) {
  std::string text;
  for (const CardValue& value : form.values) {
    char number[32];
    std::snprintf(number, sizeof number, "%g", value.number);
    text += (text.empty() ? "" : ", ") + std::string(value.name) + " = " +
            (value.word != nullptr ? value.word : number);
  }
  return text;
}

}  // namespace barreno
