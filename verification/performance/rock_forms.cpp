// SPDX-License-Identifier: BSD-3-Clause
#include "rock_forms.hpp"

#include <barreno/registry.hpp>
#include <cstdio>
#include <filesystem>
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
  struct Feature {
    const char* name;
    const char* points;  // of rock with the same third invariant
    Values values;
  };
  const std::vector<Feature> features = {
      {"plain", "", {}},
      {"scatter", "", scatter},
      {"rate", "", rate},
      {"Gudehus", "Gudehus", third_invariant("Gudehus")},
      {"Willam-Warnke", "angled", third_invariant("Willam-Warnke")},
      {"Mohr-Coulomb", "Mohr-Coulomb", third_invariant("Mohr-Coulomb")},
      {"all", "angled", third_invariant("Willam-Warnke") + rate + scatter}};
  std::vector<RockForm> forms;
  for (const std::string base : {"dry", "wet"})
    for (const Feature& feature : features) {
      const std::string shape = feature.points;
      const std::string points = shape.empty() ? base : base == "wet" ? shape + " wet" : shape;
      forms.push_back(
          {base + ", " + feature.name, points, (base == "wet" ? water : Values{}) + feature.values}
      );
    }
  forms.push_back({"dry, damage", "damaged", {}, "berea_sandstone_damage.xml"});
  forms.push_back({"dry, heat and tension cutoff", "cracked", {}, "berea_sandstone_cracks.xml"});
  forms.push_back({"dry, heat", "heated", {}, "berea_sandstone_heat.xml"});
  forms.push_back({"wet, heat", "heated wet", {}, "berea_sandstone_heat_wet.xml"});
  forms.push_back({"dry, bisection", "dry", bisection});
  forms.push_back({"wet, elastic centre", "wet", water + centre});
  forms.push_back({"wet, plastic", "wet", water + plastic});
  forms.push_back({"wet, plastic, arenisca3", "wet", water + plastic + arenisca3});
  return forms;
}

Material make_form(const std::string& base, const RockForm& form, double tolerance) {
  const std::string card = form.card == nullptr
                               ? base
                               : (std::filesystem::path(base).parent_path() / form.card).string();
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
  if (form.card != nullptr) return form.card;
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
