// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "deck/files/jet_table.hpp"
#include "scene/jet.hpp"
#include "scene/jet_kinds.hpp"

#include <gtest/gtest.h>

#include <string>

namespace barreno {
namespace {

const std::string header = "time,velocity,radius,length,density\n";

std::string problem_of(const std::string& text) {
  try {
    read_jet_table(text, "jet.csv");
  } catch (const DeckError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(JetTable, ReadsRowsInSi) {
  const auto table = read_jet_table(
      "# a comment\n" + header + "0,7830,0.001,0.001,17600\r\n\n1e-6,7000,1 mm,1 mm,17.6 g/cm3\n",
      "t"
  );
  ASSERT_EQ(table.getNumRows(), 2);
  EXPECT_EQ((table(0, 1)), 7830.0);
  EXPECT_EQ((table(1, 2)), 0.001);
  EXPECT_DOUBLE_EQ((table(1, 4)), 17600.0);
}

TEST(JetTable, ACommentMayNameTheUnits) {
  const auto table = read_jet_table("# units: mm-us-g\n" + header + "2,7.83,1,1,0.0176\n", "t");
  EXPECT_EQ((table(0, 0)), 2e-6);
  EXPECT_EQ((table(0, 1)), 7830.0);
  EXPECT_DOUBLE_EQ((table(0, 4)), 17600.0);
}

TEST(JetTable, AMarkAndSemicolonsOfASpreadsheetAreRead) {
  std::vector<std::string> notes;
  const auto table = read_jet_table(
      "\xEF\xBB\xBF"
      "time [us];velocity [km/s];radius [mm];length [mm];density [g/cm3]\r\n"
      "2;7,83;1;1,5;17,6\r\n",
      "t",
      &notes
  );
  EXPECT_DOUBLE_EQ((table(0, 0)), 2e-6);
  EXPECT_DOUBLE_EQ((table(0, 1)), 7830.0);
  EXPECT_DOUBLE_EQ((table(0, 3)), 1.5e-3);
  EXPECT_DOUBLE_EQ((table(0, 4)), 17600.0);
  EXPECT_EQ(notes.size(), 2U);
}

TEST(JetTable, RefusalsNameTheLine) {
  EXPECT_NE(problem_of("").find("contains no slug"), std::string::npos);
  EXPECT_NE(problem_of(header).find("contains no slug"), std::string::npos);
  EXPECT_NE(problem_of("a,b\n").find("line 1 = \"a,b\" is not the header"), std::string::npos);
  EXPECT_NE(
      problem_of("# x\n" + header + "0,1,1,1\n").find("line 3 has 4 values"), std::string::npos
  );
  EXPECT_NE(
      problem_of(header + "0,x,1,1,1\n").find("line 2, velocity = \"x\" is not a number"),
      std::string::npos
  );
  EXPECT_NE(
      problem_of("# units: furlong\n" + header).find("names no consistent system"),
      std::string::npos
  );
}

TEST(DiscreteSlugs, VoidBecomesLength) {
  std::string problem;
  const auto table = table_slugs({{0.0, 1000.0, 1e-3, 2e-3, 4400.0}}, 17600.0, problem);
  ASSERT_EQ(problem, "");
  const auto slugs = slugs_of_kind(table, JetKind::discrete, Mode::axisymmetric, 17600.0);
  EXPECT_DOUBLE_EQ(slugs[0].length, 0.5e-3);
  EXPECT_DOUBLE_EQ(slugs[0].density, 17600.0);
}

TEST(TableSlugs, RulesOfATable) {
  std::string problem;
  table_slugs({{1e-6, 1, 1, 1, 1}, {0.5e-6, 1, 1, 1, 1}}, 1.0, problem);
  EXPECT_NE(problem.find("launches slug 2"), std::string::npos);
  table_slugs({{0, 1, 1, 1, 2}}, 1.0, problem);
  EXPECT_NE(problem.find("a density of 2"), std::string::npos);
  table_slugs({{-1, 1, 1, 1, 1}}, 1.0, problem);
  EXPECT_NE(problem.find("a launch time"), std::string::npos);
}

}  // namespace
}  // namespace barreno
