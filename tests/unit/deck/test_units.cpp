// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <barreno/input/error.hpp>
#include <barreno/input/units.hpp>
#include <string>

namespace barreno::input {
namespace {

double si(const std::string& text, const Dimension& dimension, const std::string& system = "SI") {
  return read_quantity(text, dimension, read_unit_system(system));
}

std::string problem_of(const std::string& text, const Dimension& dimension) {
  try {
    si(text, dimension);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Units, DecimalUnitsConvertToTheNearestDouble) {
  EXPECT_EQ(si("12.7 mm", dimension::length), 0.0127);
  EXPECT_EQ(si("312.7mm", dimension::length), 0.3127);
  EXPECT_EQ(si("100 us", dimension::time), 100e-6);
  EXPECT_EQ(si("77.5 \xc2\xb5s", dimension::time), 77.5e-6);
  EXPECT_EQ(si("2.3 g/cm3", dimension::density), 2300.0);
  EXPECT_EQ(si("1.5 1/GPa", dimension::compliance), 1.5e-9);
}

TEST(Units, NamedUnits) {
  EXPECT_NEAR(si("10 ksi", dimension::stress), 68.947572931683608e6, 1e-8);
  EXPECT_EQ(si("1 in", dimension::length), 0.0254);
  EXPECT_EQ(si("294 K", dimension::temperature), 294.0);
  EXPECT_DOUBLE_EQ(si("20.85 degC", dimension::temperature), 294.0);
  EXPECT_EQ(si("4340 m/s", dimension::velocity), 4340.0);
}

TEST(Units, ProductsQuotientsPowersAndParentheses) {
  EXPECT_EQ(si("477 J/(kg K)", dimension::heat_capacity), 477.0);
  EXPECT_EQ(si("477 J/kg/K", dimension::heat_capacity), 477.0);
  EXPECT_EQ(si("477 J kg^-1 K-1", dimension::heat_capacity), 477.0);
  EXPECT_EQ(si("1 kg*m^-1*s^-2", dimension::stress), 1.0);
}

TEST(Units, PlainNumbersAreInTheNamedSystem) {
  EXPECT_EQ(si("12.7", dimension::length, "mm-us-g"), 0.0127);
  EXPECT_EQ(si("1", dimension::stress, "cm-us-g"), 1e11);
  EXPECT_EQ(si("1", dimension::stress, "mm-ms-kg"), 1e9);
  EXPECT_EQ(si("1", dimension::velocity, "us-g-mm"), 1000.0);
  EXPECT_EQ(si("10 GPa", dimension::stress, "mm-us-g"), 10e9);
}

TEST(Units, ANumberIsConsumedWhole) {
  for (const char* text :
       {"", " ", "abc", "1.2.3", "1e", "1d3", "--1", "nan", "inf", "-inf", "0x10", "1 2"}) {
    EXPECT_NE(problem_of(text, dimension::none), "accepted") << text;
    EXPECT_NE(problem_of(text, dimension::length), "accepted") << text;
  }
  EXPECT_NE(problem_of("1,5", dimension::none).find("a point, not a comma"), std::string::npos);
  EXPECT_NE(problem_of("1e400", dimension::none).find("beyond the range"), std::string::npos);
  EXPECT_EQ(si("+1.5e3", dimension::none), 1500.0);
  EXPECT_EQ(si("-.5", dimension::none), -0.5);
}

TEST(Units, BracketsAndPowersHaveBounds) {
  const auto brackets = [](int n) {
    const auto count = static_cast<std::size_t>(n);
    return "2 " + std::string(count, '(') + "mm" + std::string(count, ')');
  };
  EXPECT_EQ(read_quantity(brackets(8), dimension::length, {}), 0.002);
  EXPECT_THROW(read_quantity(brackets(9), dimension::length, {}), InputError);
  EXPECT_THROW(read_quantity("1 " + std::string(4000000, '('), dimension::length, {}), InputError);
  EXPECT_THROW(read_quantity("1 (((((m^12)^12)^12)^12)^12)^12", dimension::length, {}), InputError);
}

TEST(Units, AWrongDimensionSaysBoth) {
  EXPECT_EQ(
      problem_of("12.7 mm", dimension::time),
      "has the unit of a length ('mm'), but a time is expected here; write for example \"100 us\""
  );
  EXPECT_NE(problem_of("3 mm", dimension::none).find("unit of a length"), std::string::npos);
}

TEST(Units, InconsistentSystemsAreRefused) {
  for (const char* name : {"", "mm-us", "mm-us-g-kg", "mm-us-parsec", "mm-cm-us-g", "si"}) {
    EXPECT_THROW(read_unit_system(name), InputError) << name;
  }
}

}  // namespace
}  // namespace barreno::input
