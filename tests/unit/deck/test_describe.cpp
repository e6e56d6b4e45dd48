// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "deck/deck_schema.hpp"
#include "deck/describe_deck.hpp"
#include "deck/describe_results.hpp"
#include "deck/describe_words.hpp"
#include "deck/search_words.hpp"

#include <gtest/gtest.h>

#include <barreno/input/scan_xml.hpp>
#include <barreno/input/units.hpp>
#include <barreno/plausible.hpp>
#include <barreno/registry.hpp>
#include <filesystem>
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

TEST(Describe, SmallLettersStandForLettersOfAnyCase) {
  EXPECT_EQ(describe_text("permeability"), describe_text("Permeability"));
  EXPECT_EQ(describe_text("pore flow/rocks"), describe_text("Pore Flow/Rocks"));
  EXPECT_EQ(describe_text("arenisca"), describe_text("Arenisca"));
  EXPECT_EQ(describe_text("peaki1"), describe_text("PEAKI1"));
  EXPECT_EQ(describe_text("CHANNEL_DEPTH"), describe_text("channel_depth"));
  // A parameter and a field of that name.
  EXPECT_TRUE(has(describe_text("density"), "reference density"));
  EXPECT_TRUE(has(describe_text("density"), "particles.e of a run"));
  EXPECT_FALSE(has(describe_text("Density"), "particles.e of a run"));
}

TEST(Describe, WordsThatUsersSearchForLeadToNames) {
  for (const char* word : {"skin", "hole", "gun", "water", "Water", "casing", "holes", "mesh"})
    EXPECT_TRUE(has(describe_text(word), ".md)")) << word;
  EXPECT_TRUE(has(describe_text("water"), "  fluid_B0\n"));
  EXPECT_TRUE(has(describe_text("hole"), "depth.csv of a run\n  channel_depth\n"));
  EXPECT_TRUE(has(describe_text("gun"), "Jet\n  Launch Position\n"));
}

TEST(Describe, SearchWordsNameWhatThereIs) {
  const std::filesystem::path root =
      std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();
  for (const SearchWord& each : search_words()) {
    for (const char* const name : each.names) EXPECT_FALSE(describe_text(name).empty()) << name;
    const std::string answer = each.answer;
    const std::size_t begin = answer.find("docs/"), end = answer.find(".md");
    if (begin == std::string::npos) continue;
    const std::string page = answer.substr(begin, end + 3 - begin);
    EXPECT_TRUE(std::filesystem::exists(root / page)) << page;
  }
}

TEST(Describe, ParametersOfModelsHaveUsualRanges) {
  EXPECT_TRUE(has(describe_text("fluid_B0"), "number [Pa], >= 0; usual 50000 to 3e+10; default: 0")
  );
  for (const ModelDescription& model : describe_models()) {
    for (const input::Entry& entry : card_section(model).entries) {
      const PlausibleRange* const range = find_plausible_range(model.name, entry.name);
      if (range == nullptr) continue;
      EXPECT_FALSE(input::si_unit_of(entry.dimension).empty()) << entry.name;
      EXPECT_LT(0.0, range->lower) << entry.name;
      EXPECT_LT(range->lower, range->upper) << entry.name;
      EXPECT_TRUE(entry.bounds.contain(range->lower) || range->of_magnitude) << entry.name;
    }
    for (const PlausibleRange& range : plausible_ranges(model.name))
      EXPECT_TRUE(has(describe_text(range.parameter), std::string("Model \"") + model.name))
          << range.parameter;
  }
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
