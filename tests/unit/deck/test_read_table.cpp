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

TEST(ReadTable, FormsOfSpreadsheetsAndLaboratoriesAreTheSameTable) {
  const std::string plain = "time,speed\n0.002,1500.5\n0.004,2.5e3\n";
  std::string wide[2] = {"\xFF\xFE", "\xFE\xFF"};
  for (const char c : plain)
    for (const int k : {0, 1}) wide[k] += k == 0 ? std::string{c, '\0'} : std::string{'\0', c};
  const std::string forms[] = {
      plain,
      "\xEF\xBB\xBF" + plain,
      wide[0],
      wide[1],
      "# M\xFCller\n" + plain,
      "Time,SPEED\r\n0.002,1500.5\r\n0.004,2.5e3\r\n",
      "time,speed\r0.002,1500.5\r0.004,2.5e3\r",
      "time;speed\n0.002;1500.5\n0.004;2.5e3\n",
      "time\tspeed\n0.002\t1500.5\n0.004\t2.5e3\n",
      "time;speed\n0,002;1500,5\n0,004;2,5e3\n",
      "time\tspeed\n0,002\t1500,5\n0,004\t2,5e3\n",
      "time;speed\n0,002;1.500,5\n0,004;2.500\n",
      "time;speed\n0.002;1,500.5\n0.004;2,500\n",
      "\"time\",\"speed\"\n\"0.002\",\"1500.5\"\n\"0.004\",\"2.5e3\"\n",
      "time,speed\n\"0,002\",\"1500,5\"\n\"0,004\",\"2,5e3\"\n",
      "speed,time\n1500.5,0.002\n2.5e3,0.004\n",
      "Shot 7 of a rig\nMade by M\xFCller\ntime,speed\n0.002,1500.5\n0.004,2.5e3\n",
      "time [ms],speed [km/s]\n2,1.5005\n4,2.5\n",
      "time (ms);speed (km/s)\n2;1,5005\n4;2,5\n",
      "time,speed\nms,km/s\n2,1.5005\n4,2.5\n",
      "time;speed\n[ms];[km/s]\n2;1,5005\n4;2,5\n",
      "time [\xB5s],speed\n2000,1500.5\n4000,2.5e3\n",
      "time;speed;;\n0,002;1500,5;;\n0,004;2,5e3;;\n;;;\n",
      "# decimal: point\ntime;speed\n0.002;1,500.5\n0.004;2,500\n",
      "# units: mm-ms-g\ntime,speed\n2,1500.5\n4,2.5e3\n"};
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    TableRows rows;
    EXPECT_NO_THROW(rows = read_table(form, columns, "a test table", "t.csv")) << refusal(form);
    ASSERT_EQ(rows.values.size(), 4U);
    const double expected[] = {2e-3, 1500.5, 4e-3, 2500.0};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(rows.values[i], expected[i]);
  }
}

TEST(ReadTable, RatiosMayBeInPercent) {
  const std::vector<TableColumn> ratio{{"time", dimension::time}, {"strain", dimension::none}};
  for (const char* text :
       {"time,strain\n0,3 %\n",
        "time,strain [%]\n0,3\n",
        "time;strain\ns;%\n0;3,0\n",
        "time,strain\n0,30 permille\n",
        "time,strain\n0,30 \xE2\x80\xB0\n",
        "time,strain [microstrain]\n0,30000\n",
        "time,strain [mm/mm]\n0,0.03\n",
        "time,strain [-]\n0,3e-2\n"})
    EXPECT_DOUBLE_EQ(read_table(text, ratio, "a path", "t.csv").values[1], 0.03) << text;
}

TEST(ReadTable, GuessesAreToldAndWhatStaysOpenIsAskedFor) {
  const auto notes = read_table("Rig\ntime;speed\n0,5;1.000,5\n", columns, "", "").notes;
  const std::vector<std::string> expected = {
      "cells are separated by semicolons.",
      "line 1 stands above the column names and is not read.",
      "the decimal mark is the comma.",
      "points stand between thousands."};
  EXPECT_EQ(notes, expected);
  EXPECT_EQ(
      refusal("time;speed\n1;1,234\n"),
      "t.csv: line 2 has \"1,234\" (a decimal comma, or a comma between thousands); say which with "
      "a line \"# decimal: comma\" or \"# decimal: point\"."
  );
  EXPECT_NE(
      refusal("time;speed\n0.5;0,5\n").find("a table has one decimal mark"), std::string::npos
  );
  EXPECT_NE(
      refusal("# decimal: dot\ntime;speed\n1;2\n").find("neither comma nor"), std::string::npos
  );
  EXPECT_NE(
      refusal("# decimal: comma\ntime;speed\n0.5;0,5\n").find("a table has one"), std::string::npos
  );
  EXPECT_NE(refusal("time,speed\n0,5,1,5\n").find("decimal commas?"), std::string::npos);
  EXPECT_NE(refusal("time;speed\n1,2,3;4\n").find("line 2, time = "), std::string::npos);
  EXPECT_NE(refusal("time,time\n1,2\n").find("is not the header"), std::string::npos);
  EXPECT_NE(
      refusal("# units: m-s-g\n# units: mm-s-g\ntime,speed\n1,2\n").find("another system"),
      std::string::npos
  );
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
