// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "deck/files/read_solver_lists.hpp"
#include "deck/files/read_table.hpp"

#include <Teuchos_XMLObject.hpp>

#include <gtest/gtest.h>

#include <barreno/input/scan_xml.hpp>
#include <string>
#include <vector>

namespace barreno {
namespace {

const std::vector<TableColumn> columns{{"time", dimension::time}, {"speed", dimension::velocity}};

std::string refusal(const std::string& text) {
  try {
    read_table(text, columns, "a test table", "t.csv");
  } catch (const DeckError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadTable, TurnsRowsIntoSiAndKeepsTheirLines) {
  const TableRows rows = read_table(
      "# units: mm-us-g\n\n time , speed\r\n2,3\n# more\n4 ms, 5 m/s\n", columns, "", ""
  );
  EXPECT_EQ(rows.values, (std::vector<double>{2e-6, 3e3, 4e-3, 5.0}));
  EXPECT_EQ(rows.lines, (std::vector<int>{4, 6}));
}

TEST(ReadTable, NamesTheLineAndTheColumn) {
  const std::pair<std::string, const char*> refusals[] = {
      {"time,sped\n1,2\n", "is not the header of a test table"},
      {"time,speed\n1,2,3\n", "line 2 has 3 values (2 are expected)"},
      {"time,speed\n1,2 kg\n", "line 2, speed"},
      {"# units: furlongs\ntime,speed\n", "line 1, units"},
      {std::string("time,speed\n1,\0", 14), "zero byte"}};
  for (const auto& [text, words] : refusals)
    EXPECT_NE(refusal(text).find(words), std::string::npos) << refusal(text);
}

TEST(ReadSolverLists, GivesValuesTheTypeThatTheyLookLike) {
  const Teuchos::XMLObject root = input::parse_xml(
      R"(<ParameterList name="Deck"><ParameterList name="Pore Flow"><ParameterList name="Belos">
           <Parameter name="Count" value="3"/><Parameter name="Tolerance" value="1e-9"/>
           <Parameter name="Loud" value="true"/><Parameter name="Method" value="CG"/>
           <Parameter name="Given" type="double" value="3"/>
         </ParameterList></ParameterList></ParameterList>)",
      "deck.xml"
  );
  Teuchos::ParameterList values;
  read_solver_lists(root, "deck.xml", values);
  const Teuchos::ParameterList& belos = values.sublist("Pore Flow").sublist("Belos");
  EXPECT_EQ(belos.get<int>("Count"), 3);
  EXPECT_EQ(belos.get<double>("Tolerance"), 1e-9);
  EXPECT_TRUE(belos.get<bool>("Loud"));
  EXPECT_EQ(belos.get<std::string>("Method"), "CG");
  EXPECT_EQ(belos.get<double>("Given"), 3.0);
  EXPECT_FALSE(values.sublist("Pore Flow").isSublist("MueLu"));
}

}  // namespace
}  // namespace barreno
