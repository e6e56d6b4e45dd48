// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <unistd.h>

namespace barreno::test {

/// What a word adds to a card of Arenisca: together they reach every branch of its forms.
inline const std::map<std::string, std::string> general_words = {
    {"water", R"(<Parameter name="fluid_B0" type="double" value="2.2e9"/>
      <Parameter name="Matrix bulk modulus" type="double" value="36e9"/>)"},
    {"pressure", R"(<Parameter name="fluid_pressure_initial" type="double" value="15e6"/>)"},
    {"published", R"(<Parameter name="Backstress strain" type="string" value="plastic"/>
      <Parameter name="Undrained moduli" type="string" value="arenisca3"/>)"},
    {"gudehus", R"(<Parameter name="J3_type" type="string" value="Gudehus"/>
      <Parameter name="J3_psi" type="double" value="0.8"/>)"},
    {"willam", R"(<Parameter name="J3_type" type="string" value="Willam-Warnke"/>
      <Parameter name="J3_psi" type="double" value="0.7"/>)"},
    {"coulomb", R"(<Parameter name="J3_type" type="string" value="Mohr-Coulomb"/>
      <Parameter name="J3_psi" type="double" value="0.7"/>)"},
    {"rate", R"(<Parameter name="T1_rate_dependence" type="double" value="1e-5"/>
      <Parameter name="T2_rate_dependence" type="double" value="0.3"/>)"},
    {"scatter", R"(<Parameter name="Weibull modulus" type="double" value="8"/>
      <Parameter name="Weibull reference volume" type="double" value="1e-4"/>)"},
    {"nonassociated", R"(<Parameter name="BETA_nonassociativity" type="double" value="0.5"/>)"},
    {"bisection", R"(<Parameter name="Return solver" type="string" value="bisection"/>)"}};

/// Writes the card with what the words add, CARD+WORD+WORD, among the temporary files.
/// @return its path, the caller's to remove; empty if the card cannot be read or a word is unknown
inline std::string card_with_words(const std::string& asked) {
  std::istringstream words(asked);
  std::string name, word, more;
  std::getline(words, name, '+');
  while (std::getline(words, word, '+')) {
    const auto found = general_words.find(word);
    if (found == general_words.end()) return {};
    more += found->second + "\n";
  }
  std::ifstream file(BARRENO_SOURCE_DIR "/materials/cards/" + name + ".xml");
  std::ostringstream text;
  text << file.rdbuf();
  std::string card = text.str();
  const auto end = card.rfind("</ParameterList>");
  if (!file || end == std::string::npos) return {};
  card.insert(end, more);
  std::string path =
      std::filesystem::temp_directory_path() / (asked + "_" + std::to_string(::getpid()) + ".xml");
  std::ofstream(path) << card;
  return path;
}

}  // namespace barreno::test
