// SPDX-License-Identifier: BSD-3-Clause
#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <gtest/gtest.h>

#include <barreno/input/error.hpp>
#include <barreno/input/scan_xml.hpp>
#include <string>

namespace barreno::input {
namespace {

Section table_of_tests() {
  const Section item = {
      "*",
      "an item",
      Presence::required,
      {number("Mass", dimension::mass, above(0.0), "its mass")},
      {},
      {}};
  const Section optional_part = {
      "Extra",
      "may be absent",
      Presence::optional,
      {number("Needed", dimension::none, any(), "x")},
      {},
      {}};
  const Section filled_part = {
      "Filled",
      "filled when absent",
      Presence::defaulted,
      {number("Step", dimension::time, at_least(0.0), "x").by_default("0.5")},
      {},
      {}};
  return {
      "Test",
      "all kinds",
      Presence::required,
      {number("Length", dimension::length, above(0.0), "a length"),
       integer("Count", between(0, 2e6), "a count").by_default("3"),
       word("Colour", {"red", "green"}, "a colour").by_default("red"),
       words("Faces", {"top", "bottom"}, "faces").if_given(),
       flag("Loud", "a flag").by_default("false"),
       vector("Corner", dimension::length, any(), "a corner").if_given(),
       table("Rows", {dimension::time, dimension::length}, "rows").if_given(),
       text("Name", "a text").if_given()},
      {optional_part, filled_part, {"Items", "items", Presence::defaulted, {}, {}, {item}}},
      {}};
}

Teuchos::ParameterList scan(const std::string& body, const std::string& units = "SI") {
  const auto xml = parse_xml("<ParameterList name=\"t\">" + body + "</ParameterList>", "t.xml");
  return scan_list(xml, table_of_tests(), "", {"t.xml", read_unit_system(units)});
}

std::string problem_of(const std::string& body) {
  try {
    scan(body);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string length = "<Parameter name=\"Length\" type=\"string\" value=\"2 mm\"/>";

std::string parameter(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" value=\"" + value + "\"/>";
}

TEST(ParseXml, AByteOrderMarkIsSkippedAndUtf16Named) {
  const std::string text = R"(<?xml version="1.0"?><ParameterList name="Deck"/>)";
  EXPECT_EQ(parse_xml("\xEF\xBB\xBF" + text, "deck.xml").getTag(), "ParameterList");
  try {
    parse_xml(std::string("\xFF\xFE<\0?\0", 6), "deck.xml");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("UTF-16"), std::string::npos) << error.what();
  }
}

TEST(ScanXml, FillsDefaultsAndConverts) {
  const auto list = scan(length);
  EXPECT_EQ(list.get<double>("Length"), 0.002);
  EXPECT_EQ(list.get<int>("Count"), 3);
  EXPECT_EQ(list.get<std::string>("Colour"), "red");
  EXPECT_FALSE(list.get<bool>("Loud"));
  EXPECT_FALSE(list.isParameter("Corner"));
  EXPECT_FALSE(list.isSublist("Extra"));
  EXPECT_TRUE(list.isSublist("Items"));
}

TEST(ScanXml, DefaultsAreInSiWhateverTheUnitsOfTheDeck) {
  const auto list = scan(parameter("Length", "2"), "mm-us-g");
  EXPECT_EQ(list.get<double>("Length"), 0.002);
  EXPECT_EQ(list.sublist("Filled").get<double>("Step"), 0.5);
}

TEST(ScanXml, ArraysAndTables) {
  const auto list = scan(
      length + parameter("Corner", "{1 mm, -2}") +
      parameter("Rows", "2x2:{1 us, 1 mm, 2 us, 2 mm}") + parameter("Faces", "{bottom, top}")
  );
  EXPECT_EQ(
      list.get<Teuchos::Array<double>>("Corner").toVector(), (std::vector<double>{0.001, -2.0})
  );
  EXPECT_EQ((list.get<Teuchos::TwoDArray<double>>("Rows")(1, 0)), 2e-6);
  EXPECT_EQ(list.get<Teuchos::Array<std::string>>("Faces")[1], "top");
  EXPECT_NE(
      problem_of(length + parameter("Rows", "2x2:{1, 2, 3}")).find("holds 3 values"),
      std::string::npos
  );
}

TEST(ScanXml, IntegersMayBeWrittenAsExactNumbers) {
  EXPECT_EQ(scan(length + parameter("Count", "1e6")).get<int>("Count"), 1000000);
  EXPECT_NE(
      problem_of(length + parameter("Count", "1.5")).find("not a whole number"), std::string::npos
  );
  EXPECT_NE(problem_of(length + parameter("Count", "4 mm")), "accepted");
}

TEST(ScanXml, NearestNames) {
  EXPECT_EQ(
      problem_of(parameter("Lenght", "2 mm")),
      "t.xml: Lenght is not a known parameter; did you mean 'Length'?"
  );
  EXPECT_NE(
      problem_of(length + parameter("colour", "red")).find("did you mean 'Colour'?"),
      std::string::npos
  );
  EXPECT_NE(
      problem_of(length + parameter("Colour", "gren")).find("did you mean 'green'?"),
      std::string::npos
  );
}

TEST(ScanXml, PathsNameTheSubList) {
  const std::string items = "<ParameterList name=\"Items\"><ParameterList name=\"A\">" +
                            parameter("Mass", "-1") + "</ParameterList></ParameterList>";
  EXPECT_EQ(
      problem_of(length + items),
      "t.xml: Items/A/Mass = -1 is out of bounds (it must be above 0 kg); choose a value in that "
      "range."
  );
}

TEST(ScanXml, PartialListsNeedNothingAndFillNothing) {
  const auto xml =
      parse_xml("<ParameterList name=\"t\">" + parameter("Count", "4") + "</ParameterList>", "t");
  const auto list = scan_list(xml, table_of_tests(), "", {"t", {}}, Completeness::partial);
  EXPECT_EQ(list.numParams(), 1);
}

TEST(ScanXml, WhatTeuchosLetsThroughIsRefused) {
  EXPECT_NE(problem_of(length + length).find("given twice"), std::string::npos);
  EXPECT_NE(problem_of(length + "<ParameterList/>").find("without a name"), std::string::npos);
  EXPECT_NE(problem_of(parameter("Length", "abc")).find("is not a number"), std::string::npos);
  EXPECT_NE(problem_of("").find("Length is missing"), std::string::npos);
  EXPECT_NE(
      problem_of("<Parameter name=\"Length\" type=\"bool\" value=\"1\"/>")
          .find("has the type 'bool'"),
      std::string::npos
  );
}

TEST(ScanXml, OverridesReplaceAndAdd) {
  const auto xml = parse_xml("<ParameterList name=\"t\">" + length + "</ParameterList>", "t");
  override_value(xml, "Length=5 mm");
  override_value(xml, "Filled/Step = 1e-3");
  const auto list = scan_list(xml, table_of_tests(), "", {"t", {}});
  EXPECT_EQ(list.get<double>("Length"), 0.005);
  EXPECT_EQ(list.sublist("Filled").get<double>("Step"), 1e-3);
  EXPECT_THROW(override_value(xml, "Length"), InputError);
  EXPECT_THROW(override_value(xml, "/=3"), InputError);
  EXPECT_THROW(override_value(xml, "Title=a\x1b[2J"), InputError);
}

TEST(ScanXml, OverridesTakeAway) {
  const std::string items = "<ParameterList name=\"Items\"><ParameterList name=\"A\">" +
                            parameter("Mass", "1") + "</ParameterList></ParameterList>";
  const auto xml = parse_xml(
      "<ParameterList name=\"t\">" + length + parameter("Count", "4") + items + "</ParameterList>",
      "t"
  );
  const auto list_with = [&](const std::string& assignment) {
    return scan_list(override_value(xml, assignment), table_of_tests(), "", {"t", {}});
  };
  EXPECT_EQ(list_with("Count=5").get<int>("Count"), 5);
  EXPECT_EQ(list_with("Count=").get<int>("Count"), 3);
  EXPECT_THROW(list_with("Length= "), InputError);
  EXPECT_TRUE(list_with("Count=").sublist("Items").isSublist("A"));
  EXPECT_FALSE(list_with("Items/A=").sublist("Items").isSublist("A"));
  EXPECT_THROW(list_with("Items/A/Mass="), InputError);
  for (const char* absent : {"Cuont=", "Items/B=", "Nothing/Mass="}) try {
      override_value(xml, absent);
      ADD_FAILURE() << absent;
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find("removes something that is not there"), std::string::npos) << said;
    }
}

TEST(ParseXml, NamesAreOneLine) {
  for (const char* end : {"&#10;", "&#13;", "&#9;"}) {
    const std::string name = std::string("a") + end + "Note: forged";
    for (const char* tag : {"Parameter", "ParameterList"}) try {
        parse_xml(
            "<ParameterList name=\"t\"><" + (tag + (" name=\"" + name)) + "\"/></ParameterList>",
            "t"
        );
        ADD_FAILURE() << name;
      } catch (const InputError& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find("has the name \"a Note: forged\""), std::string::npos) << said;
      }
  }
}

TEST(ParseXml, HostileTextsAreRefused) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<ParameterList name=\"a\">";
  EXPECT_THROW(parse_xml(deep, "t"), InputError);
  EXPECT_THROW(parse_xml(std::string(largest_text + 1, ' '), "t"), InputError);
  EXPECT_THROW(parse_xml("<!doctype a><ParameterList name=\"a\"/>", "t"), InputError);
  EXPECT_THROW(parse_xml(std::string("<ParameterList name=\"a\"/>") + '\0', "t"), InputError);
  EXPECT_THROW(parse_xml("<ParameterList name=\"&#0;\"/>", "t"), InputError);
  EXPECT_THROW(parse_xml("<a/>", "t"), InputError);
  EXPECT_THROW(parse_xml("", "t"), InputError);
}

/// Quadratic reading would take hours, recursion the stack.
TEST(ParseXml, LongTextsAreReadInOnePass) {
  const std::size_t many = 4000000;
  EXPECT_THROW(parse_xml(std::string(many, '<') + ">", "t"), InputError);
  try {
    parse_xml("<" + std::string(many, 'a') + "></b>", "t");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_LT(std::string(error.what()).size(), 400U);
  }
}

TEST(ParseXml, ValuesMayHoldWhatLooksLikeTags) {
  std::string text = "<ParameterList name=\"a\">";
  for (int i = 0; i < 2 * deepest_nesting; ++i) text += "<Parameter name='b' value=\"c>d'>\"/>";
  EXPECT_EQ(parse_xml(text + "</ParameterList>", "t").numChildren(), 2 * deepest_nesting);
  std::string deep = "<ParameterList name=\"/>\">";
  for (int i = 0; i < deepest_nesting; ++i) deep += deep.substr(0, 25);
  EXPECT_THROW(parse_xml(deep, "t"), InputError);
}

TEST(ScanXml, SentencesStayShort) {
  const std::string problem = problem_of(parameter(std::string(100000, 'n'), "1"));
  EXPECT_LT(problem.size(), 2500U);
  EXPECT_NE(problem.find("is not a known parameter"), std::string::npos);
  EXPECT_EQ(shown("a\nb"), "\"a b\"");
  // No character of several bytes is cut.
  EXPECT_EQ(
      shown(std::string(56, 'a') + "\xc3\xa9\xc3\xa9\xc3\xa9"),
      "\"" + std::string(56, 'a') + "...\""
  );
}

TEST(ParseXml, ErrorsNameTheLine) {
  try {
    parse_xml("<ParameterList name=\"a\">\n\n</Parameter>", "t.xml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("t.xml is not well-formed XML at line 3", 0), 0U)
        << error.what();
  }
}

}  // namespace
}  // namespace barreno::input
