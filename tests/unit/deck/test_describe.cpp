// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "deck/deck_schema.hpp"
#include "deck/describe_deck.hpp"
#include "deck/describe_results.hpp"
#include "deck/describe_words.hpp"

#include <gtest/gtest.h>

#include <barreno/input/scan_xml.hpp>
#include <string>

namespace barreno {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A path as a user has it in a deck: lists of free name have one.
std::string in_a_deck(const std::string& path) {
  std::string named;
  for (const char c : path) named += c == '*' ? std::string("Mine") : std::string(1, c);
  return named;
}

/// An entry as `describe` lays it out: its name in a line, its meaning in the next.
std::string as_written(const input::Entry& entry) {
  return "  " + entry.name + "\n      " + entry.meaning + "\n";
}

/// The schema itself, walked by this test, and not by what `describe` walks it with.
void count_sections(const input::Section& section, int& count) {
  ++count;
  for (const input::Section& part : section.sections) count_sections(part, count);
  for (const input::Section& named : section.named) count_sections(named, count);
}

TEST(Describe, EverySectionOfTheSchemaIsPlaced) {
  int count = -1;  // the deck itself
  count_sections(deck_schema(), count);
  EXPECT_EQ(static_cast<int>(placed_sections().size()), count);
  EXPECT_GT(count, 25);
}

TEST(Describe, EverySectionOfADeckIsDescribedByItsPath) {
  for (const PlacedSection& placed : placed_sections()) {
    SCOPED_TRACE(placed.path);
    const std::string text = describe_text(in_a_deck(placed.path));
    EXPECT_TRUE(has(text, placed.path + ": " + placed.section->meaning));
    for (const input::Entry& entry : placed.section->entries)
      EXPECT_TRUE(has(text, as_written(entry))) << entry.name;
  }
}

TEST(Describe, EveryParameterIsDescribedByItsNameAndByItsPath) {
  for (const input::Entry& entry : deck_schema().entries)
    EXPECT_TRUE(has(describe_text(entry.name), "at the top of the deck\n" + as_written(entry)));
  for (const PlacedSection& placed : placed_sections())
    for (const input::Entry& entry : placed.section->entries) {
      const std::string path = input::join(placed.path, entry.name);
      SCOPED_TRACE(path);
      const std::string wanted = placed.path + "\n" + as_written(entry);
      EXPECT_TRUE(has(describe_text(entry.name), wanted));
      EXPECT_TRUE(has(describe_text(in_a_deck(path)), wanted));
    }
}

TEST(Describe, TheOverviewNamesEverySection) {
  const std::string overview = describe_text("");
  for (const PlacedSection& placed : placed_sections()) {
    if (placed.section->name == "*") continue;
    EXPECT_TRUE(has(overview, "\n  " + placed.path + ": ")) << placed.path;
  }
}

TEST(Describe, ParametersAndHistoryOfModels) {
  const std::string vertex = describe_text("PEAKI1");
  EXPECT_TRUE(has(vertex, "Model \"Arenisca\"\n  PEAKI1\n      I1 at the tensile vertex\n"));
  for (const ModelDescription& model : describe_models())
    for (const auto& fields : {model.history, model.more_history})
      for (const HistoryField& field : fields)
        EXPECT_TRUE(has(describe_text(field.name), std::string(": ") + field.meaning))
            << field.name;
}

TEST(Describe, ANameOfTwoSectionsDescribesBoth) {
  const std::string text = describe_text("Conditions");
  EXPECT_TRUE(has(text, "\nPore Flow/Conditions: ")) << text;
  EXPECT_EQ(text.rfind("Conditions: prescribed motion", 0), 0U) << text;
  EXPECT_FALSE(has(describe_text("Pore Flow/Conditions"), "prescribed motion"));
}

TEST(Describe, WordsOfARunsFilesAreThoseOfThePage) {
  EXPECT_TRUE(
      has(describe_text("channel_depth"),
          "depth.csv of a run\n  channel_depth\n      length of the open channel")
  );
  EXPECT_TRUE(has(describe_text("stress_zx"), "particles.e of a run\n  stress_zx\n      stress; "));
  EXPECT_TRUE(has(describe_text("penetration.depth_error.low"), "summary.json of a run\n"));
}

TEST(Describe, WordsOfAPageStandInItsMarkedTables) {
  const std::string page =
      "| `early` | s | outside |\n<!-- words of a.csv -->\n| column | unit | meaning "
      "|\n|---|---|---|\n"
      "| `v_x`, `_y` | m/s | of the tip |\n| `a.b`, `.c` | - | `two`, see [x.md](x.md#y) |\n<!-- "
      "end of words -->\n| "
      "`late` | s | outside |\n";
  EXPECT_EQ(
      describe_result(page, "v_y"), "a.csv of a run\n  v_y\n      of the tip\n      in m/s\n"
  );
  EXPECT_EQ(describe_result(page, "c"), "a.csv of a run\n  a.c\n      two, see x.md\n");
  EXPECT_EQ(describe_result(page, "a.b"), "a.csv of a run\n  a.b\n      two, see x.md\n");
  EXPECT_EQ(describe_result(page, "a"), "a.csv of a run\n  a.b\n  a.c\n      two, see x.md\n");
  for (const char* name : {"early", "late", "v", "", ".", "column"})
    EXPECT_TRUE(describe_result(page, name).empty()) << name;
  EXPECT_TRUE(describe_result("", "v_x").empty());
}

TEST(Describe, WhatNobodyHasIsRefusedWithTheNearestName) {
  const auto refusal = [](const std::string& name) {
    try {
      describe_text(name);
    } catch (const DeckError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_TRUE(has(refusal("Permeabilty"), "did you mean 'Permeability'?"));
  EXPECT_TRUE(has(refusal("Pore Flow/Rock"), "did you mean 'Pore Flow/Rocks'?"));
  EXPECT_TRUE(has(refusal("channel_dept"), "nor a word of a run's files (docs/output.md)"));
  EXPECT_TRUE(has(refusal("xyzzy"), "choose one of 'Grid', "));
  EXPECT_FALSE(has(refusal("xyzzy"), "Permeability"));
  for (const char* name : {"*", "/", "Grid/Cell Size/x"})
    EXPECT_FALSE(refusal(name).empty()) << name;
}

}  // namespace
}  // namespace barreno
