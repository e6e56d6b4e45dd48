// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace barreno::test {

/// Berea sandstone full of water; cards for the forms of Arenisca differ in little else.
inline const std::string water_in_quartz = R"(
  <Parameter name="fluid_B0" type="double" value="2.2e9"/>
  <Parameter name="Matrix bulk modulus" type="double" value="36e9"/>)";
/// All that a card can ask for.
inline const std::string everything_general = water_in_quartz + R"(
  <Parameter name="fluid_pressure_initial" type="double" value="15e6"/>
  <Parameter name="J3_type" type="string" value="Willam-Warnke"/>
  <Parameter name="J3_psi" type="double" value="0.8"/>
  <Parameter name="T1_rate_dependence" type="double" value="1e-5"/>
  <Parameter name="T2_rate_dependence" type="double" value="0.3"/>
  <Parameter name="Weibull modulus" type="double" value="8"/>
  <Parameter name="Weibull reference volume" type="double" value="1e-4"/>)";

/// The form of the pore fluid that goes with the general form itself.
inline const std::string about_the_elastic_centre = R"(
  <Parameter name="Backstress strain" type="string" value="elastic centre"/>)";
inline const std::string overstress = R"(
  <Parameter name="T1_rate_dependence" type="double" value="1e-5"/>
  <Parameter name="T2_rate_dependence" type="double" value="0.3"/>)";
inline const std::string scatter = R"(
  <Parameter name="Weibull modulus" type="double" value="8"/>
  <Parameter name="Weibull reference volume" type="double" value="1e-4"/>)";
inline const std::string third_invariant = R"(
  <Parameter name="J3_type" type="string" value="Willam-Warnke"/>
  <Parameter name="J3_psi" type="double" value="0.8"/>)";
inline const std::string by_bisection = R"(
  <Parameter name="Return solver" type="string" value="bisection"/>)";

/// Writes the card of Berea sandstone with more parameters.
/// @return its path
inline std::string berea_card_with(const std::string& parameters, const std::string& name) {
  std::ifstream berea(BARRENO_SOURCE_DIR "/materials/cards/berea_sandstone.xml");
  std::ostringstream text;
  text << berea.rdbuf();
  std::string card = text.str();
  const auto end = card.rfind("</ParameterList>");
  EXPECT_NE(end, std::string::npos);
  card.insert(end, parameters + "\n");
  std::string path = ::testing::TempDir() + name + ".xml";
  std::ofstream(path) << card;
  return path;
}

}  // namespace barreno::test
