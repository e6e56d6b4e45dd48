// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/process.hpp"
#include "base/utf8.hpp"
#include "deck/deck_schema.hpp"
#include "deck/describe_deck.hpp"
#include "deck/echo_deck.hpp"
#include "deck/files/read_deck.hpp"
#include "scene/build_scene.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_TwoDArray.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>

#include <gtest/gtest.h>

#include <barreno/input/scan_xml.hpp>
#include <barreno/models.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace barreno {
namespace {

/// A deck with a card, a jet and a confinement, in a folder that goes with the test.
class ReadDeck : public ::testing::Test {
protected:
  ReadDeck() {
    std::string name = (std::filesystem::temp_directory_path() / "barreno_deck_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    write("rubber.xml", R"xml(<ParameterList name="Rubber">
      <Parameter name="Units" type="string" value="mm-us-g"/>
      <Parameter name="Schema Version" type="int" value="1"/>
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="double" value="1e-3"/>
      <Parameter name="Bulk Modulus" type="string" value="6 MPa"/>
      <Parameter name="Shear Modulus" type="string" value="3 MPa"/></ParameterList>)xml");
    write(
        "jet.csv",
        "time,velocity,radius,length,density\n0,1000,0.0013,0.001,500\n1e-6,900,1 mm,1 mm,1000\n"
    );
    write("deck.xml", R"xml(<ParameterList name="Deck">
      <Parameter name="Schema Version" type="int" value="1"/>
      <Parameter name="Title" type="string" value="a &lt; b &amp; &quot;c&quot;"/>
      <Parameter name="Units" type="string" value="mm-us-g"/>
      <ParameterList name="Grid"><Parameter name="Mode" type="string" value="axisymmetric"/>
        <Parameter name="Lower" type="Array(double)" value="{0, -20}"/>
        <Parameter name="Upper" type="Array(double)" value="{20, 4 cm}"/>
        <Parameter name="Cell Size" type="double" value="1"/></ParameterList>
      <ParameterList name="Materials"><ParameterList name="Rubber">
        <Parameter name="Card" type="string" value="rubber.xml"/>
        <Parameter name="Shear Modulus" type="string" value="2 MPa"/></ParameterList></ParameterList>
      <ParameterList name="Bodies">
        <ParameterList name="Front"><Parameter name="Material" type="string" value="Rubber"/>
          <Parameter name="Lower" type="string" value="{0, 0}"/>
          <Parameter name="Upper" type="string" value="{10, 12.7}"/></ParameterList>
        <ParameterList name="Back"><Parameter name="Material" type="string" value="Rubber"/>
          <Parameter name="Lower" type="string" value="{0, 12.7}"/>
          <Parameter name="Upper" type="string" value="{10, 30}"/></ParameterList></ParameterList>
      <ParameterList name="Conditions"><ParameterList name="Axis">
        <Parameter name="Face" type="string" value="x_lower"/>
        <Parameter name="Kind" type="string" value="symmetry"/></ParameterList></ParameterList>
      <ParameterList name="Confinement"><Parameter name="Pressure" type="string" value="1 kPa"/>
        <Parameter name="Bodies" type="string" value="{Front, Back}"/></ParameterList>
      <ParameterList name="Jet"><Parameter name="Material" type="string" value="Rubber"/>
        <Parameter name="Table" type="string" value="jet.csv"/>
        <Parameter name="Launch Position" type="double" value="-5"/>
        <Parameter name="Direction" type="string" value="+y"/></ParameterList>
      <ParameterList name="Time"><Parameter name="End Time" type="double" value="40"/></ParameterList>
      </ParameterList>)xml");
  }
  ~ReadDeck() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  Deck read(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    return read_deck((folder_ / name).string(), overrides, Teuchos::SerialComm<int>());
  }

  const std::filesystem::path& folder() const { return folder_; }

private:
  std::filesystem::path folder_;
};

TEST_F(ReadDeck, TheSceneIsInSi) {
  const Scene scene = build_scene(read("deck.xml"));
  EXPECT_EQ(scene.grid.upper[1], 0.04);
  EXPECT_EQ(scene.end_time, 40e-6);
  EXPECT_EQ(std::get<Box>(scene.bodies[0].shape).upper[1], 0.0127);
  EXPECT_EQ(scene.materials[0].density(), 1000.0);
  const auto& rubber = std::get<LinearElastic>(scene.materials[0].material().model);
  EXPECT_EQ(rubber.parameters().bulk_modulus, 6e6);
  EXPECT_EQ(rubber.parameters().shear_modulus, 2e6);
  ASSERT_EQ(scene.jet.slugs.size(), 2U);
  EXPECT_DOUBLE_EQ(scene.jet.slugs[0].length, 0.0005);
}

TEST_F(ReadDeck, ConfinementPressesOuterFacesOnly) {
  const Scene scene = build_scene(read("deck.xml"));
  ASSERT_EQ(scene.loads.size(), 2U);
  const std::array<bool, 6> front = {false, true, true, false, false, false};
  const std::array<bool, 6> back = {false, true, false, true, false, false};
  EXPECT_EQ(scene.loads[0].faces, front);
  EXPECT_EQ(scene.loads[1].faces, back);
  EXPECT_EQ(scene.bodies[1].initial_pressure, 1000.0);
  EXPECT_EQ(scene.loads[0].pressure(1.0), 1000.0);
}

TEST_F(ReadDeck, TheEffectiveDeckGivesTheSameDeckWithoutOtherFiles) {
  const Deck deck = read("deck.xml", {"Step/Courant Fraction=0.3"});
  const std::string xml = effective_deck_xml(deck);
  EXPECT_EQ(xml.find("rubber.xml\"/>\n      <Parameter name=\"Card"), std::string::npos);
  write("effective.xml", xml);
  const Deck again = read("effective.xml");
  EXPECT_EQ(again.values(), deck.values());
  EXPECT_EQ(again.number("Step/Courant Fraction"), 0.3);
  EXPECT_EQ(again.word("Title"), "a < b & \"c\"");
}

/// Of XML 1.0: what a comment and a document may not hold, and that a line end in a value is a
/// reference, which every reader gives back.
void expect_well_formed(const std::string& xml, const std::string& name) {
  const std::size_t end = xml.find("-->");
  ASSERT_NE(end, std::string::npos) << name;
  EXPECT_EQ(xml.substr(4, end - 4).find("--"), std::string::npos) << name;
  EXPECT_EQ(xml.find('\n'), end + 3) << name;
  for (std::size_t at = 0; at < xml.size();) {
    const std::size_t bytes = character_bytes(xml, at);
    ASSERT_GT(bytes, 0U) << name;
    EXPECT_TRUE(xml[at] == '\n' || static_cast<unsigned char>(xml[at]) >= ' ') << name;
    at += bytes;
  }
}

TEST_F(ReadDeck, NamesOfAnyBytesGiveAnEffectiveDeckThatIsXml) {
  const std::string plain = effective_deck_xml(read("deck.xml"));
  for (const char* name :
       {"a--b.xml",
        "---",
        "-->.xml",
        "a\nb.xml",
        "a\x1b[31m\x01.xml",
        "\xff\xfe.xml",
        "\xc3.xml",
        "\xed\xa0\x80.xml",
        "\"'&<!DOCTYPE.xml",
        "\xc3\xa9\xe2\x82\xac.xml"}) {
    std::filesystem::copy_file(folder() / "deck.xml", folder() / name);
    const std::string xml = effective_deck_xml(read(name));
    expect_well_formed(xml, name);
    EXPECT_EQ(xml.substr(xml.find('\n')), plain.substr(plain.find('\n'))) << name;
    write("effective.xml", xml);
    EXPECT_EQ(read("effective.xml").values(), read("deck.xml").values()) << name;
  }
}

TEST_F(ReadDeck, TextsOfAnyBytesComeBackFromTheEffectiveDeck) {
  const std::string title = "two\nlines\tand a tab, \xe9 of Latin-1, \xe2\x82\xac, \xf5\x80";
  const Deck deck = read("deck.xml", {"Title=" + title});
  const std::string xml = effective_deck_xml(deck);
  expect_well_formed(xml, title);
  write("effective.xml", xml);
  EXPECT_EQ(read("effective.xml").word("Title"), title);
  EXPECT_THROW(read("deck.xml", {"Title=\x1b[2J"}), DeckError);
  write("escape.xml", "<ParameterList name=\"a\"><ParameterList name=\"&#27;c\"/></ParameterList>");
  try {
    read("escape.xml");
    FAIL() << "a control character was read";
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("control character 27"), std::string::npos)
        << error.what();
  }
}

TEST_F(ReadDeck, TeuchosItselfReadsTheEffectiveDeckAlike) {
  const Deck deck = read("deck.xml");
  const auto list = Teuchos::getParametersFromXmlString(effective_deck_xml(deck));
  EXPECT_EQ(list->sublist("Grid").get<double>("Cell Size"), 0.001);
  EXPECT_EQ(
      list->sublist("Jet").get<Teuchos::TwoDArray<double>>("Slugs"),
      deck.values().sublist("Jet").get<Teuchos::TwoDArray<double>>("Slugs")
  );
}

TEST_F(ReadDeck, NoPorePressureIsOneOfDryRock) {
  EXPECT_NO_THROW(build_scene(read("deck.xml", {"Bodies/Front/Pore Pressure=0"})));
  EXPECT_THROW(build_scene(read("deck.xml", {"Bodies/Front/Pore Pressure=1 Pa"})), DeckError);
}

TEST_F(ReadDeck, ACardIsNamedWithOrWithoutItsEnding) {
  const Deck deck = read("deck.xml");
  for (const char* name : {"rubber", "rubber.xml"})
    EXPECT_EQ(
        read("deck.xml", {std::string("Materials/Rubber/Card=") + name})
            .number("Materials/Rubber/Density"),
        deck.number("Materials/Rubber/Density")
    ) << name;
  EXPECT_NO_THROW(
      read("deck.xml", {"Materials/Rubber/Card=berea_sandstone", "Materials/Rubber/Shear Modulus="})
  );
}

TEST_F(ReadDeck, AnOverrideTakesAway) {
  const Deck deck = read("deck.xml", {"Materials/Rubber/Shear Modulus=", "Jet=", "Title="});
  EXPECT_EQ(deck.number("Materials/Rubber/Shear Modulus"), 3e6);  // the card's own
  EXPECT_FALSE(deck.has("Jet/Material"));
  EXPECT_EQ(deck.word("Title"), "");
  EXPECT_THROW(read("deck.xml", {"Jet/Materail="}), DeckError);
}

TEST_F(ReadDeck, AnOverrideIsCheckedLikeTheDeck) {
  EXPECT_THROW(read("deck.xml", {"Step/Courant Fractoin=0.3"}), DeckError);
  EXPECT_THROW(read("deck.xml", {"Step/Courant Fraction=3"}), DeckError);
  EXPECT_THROW(read("deck.xml", {"Materials/Rubber/Card=nowhere.xml"}), FileError);
}

/// Whether one of the notes holds the text.
bool notes_say(const Deck& deck, const std::string& text) {
  for (const std::string& note : deck.notes)
    if (note.find(text) != std::string::npos) return true;
  return false;
}

TEST_F(ReadDeck, AFidelityFillsWhatTheDeckDoesNotSay) {
  const Deck plain = read("deck.xml"), fast = read("deck.xml", {"Fidelity=fast"});
  EXPECT_EQ(plain.word("Step/Shape Function"), "GIMP");
  EXPECT_EQ(plain.number("Step/Largest Strain"), 0.5);
  EXPECT_EQ(fast.word("Step/Shape Function"), "GIMP");  // as it has a jet
  EXPECT_EQ(fast.number("Step/Courant Fraction"), 0.8);
  EXPECT_EQ(fast.integer("Jet/Particles Per Cell"), 2);
  EXPECT_EQ(fast.number("Jet/Cells Per Radius"), 0.0);  // the deck gives Cell Size
  EXPECT_EQ(fast.number("Output/Field Interval"), 0.0);
  EXPECT_EQ(fast.number("Output/History Interval"), 4e-7);  // a hundredth of 40 us
  EXPECT_TRUE(plain.notes.empty());
  EXPECT_TRUE(notes_say(fast, "Step/Shape Function = GIMP, "));
  EXPECT_FALSE(notes_say(fast, "The deck's own words"));
}

TEST_F(ReadDeck, AFidelityChoosesCellsAndStepsForAJet) {
  const Deck balanced = read("deck.xml", {"Fidelity=balanced", "Step/Subcycles=2"});
  EXPECT_EQ(balanced.number("Jet/Cells Per Radius"), 2.0);  // the deck gives Cell Size
  EXPECT_EQ(balanced.integer("Bodies/Back/Particles Per Cell"), 1);
  EXPECT_EQ(balanced.integer("Step/Subcycles"), 2);
  EXPECT_EQ(balanced.number("Step/Largest Strain"), 0.1);
  EXPECT_EQ(balanced.chosen_by_fidelity.count("Jet/Cells Per Radius"), 1U);
  EXPECT_EQ(balanced.chosen_by_fidelity.count("Step/Subcycles"), 0U);
  const Deck reference = read("deck.xml", {"Fidelity=reference"});
  EXPECT_EQ(reference.word("Step/Shape Function"), "GIMP");
  EXPECT_EQ(reference.number("Jet/Cells Per Radius"), 4.0);
  EXPECT_EQ(reference.integer("Bodies/Back/Particles Per Cell"), 2);
  const Scene scene = build_scene(reference);
  EXPECT_EQ(scene.step.subcycles, 4);
  EXPECT_FALSE(scene.grid.level_of_tile.empty());
  EXPECT_TRUE(scene.left_out.empty());
}

/// The thinnest slug has a radius of 1 mm, the box is 20 mm by 60 mm.
TEST_F(ReadDeck, CellsFollowTheJetWhereTheDeckLeavesThemOpen) {
  const std::string open = "Grid/Cell Size=";
  const Deck plain = read("deck.xml", {open});
  EXPECT_DOUBLE_EQ(plain.number("Grid/Cell Size"), 1e-3);
  EXPECT_TRUE(notes_say(plain, "Grid/Cell Size = 0.001 m follows from the jet (1 cell in the"));
  const Deck fast = read("deck.xml", {open, "Fidelity=fast"});
  EXPECT_DOUBLE_EQ(fast.number("Jet/Cells Per Radius"), 1.8);
  EXPECT_DOUBLE_EQ(fast.number("Grid/Cell Size"), 2e-3 / 1.8);  // one level: 1.8 in a radius
  EXPECT_EQ(fast.integer("Bodies/Back/Particles Per Cell"), 1);
  EXPECT_DOUBLE_EQ(read("deck.xml", {open, "Fidelity=reference"}).number("Grid/Cell Size"), 1e-3);
  const std::vector<std::string> many = {open, "Jet/Cells Per Radius=40"};
  EXPECT_DOUBLE_EQ(read("deck.xml", many).number("Grid/Cell Size"), 0.4e-3);  // at most four levels
  const std::vector<std::string> no_path = {open, "Fidelity=fast", "Step/Transfer=XPIC"};
  const Deck without = read("deck.xml", no_path);
  EXPECT_DOUBLE_EQ(without.number("Grid/Cell Size"), 1e-3);
  EXPECT_EQ(without.integer("Bodies/Back/Particles Per Cell"), 2);
  EXPECT_TRUE(notes_say(
      without,
      "Bodies have 2 particles per cell and direction, not 1 as the fidelity chose for a refined "
      "path: Step/Transfer = XPIC does not work across cells of different sizes yet."
  ));
  const std::vector<std::string> taller = {open, "Grid/Upper={20, 40.5}"};
  EXPECT_DOUBLE_EQ(read("deck.xml", taller).number("Grid/Cell Size"), 0.5e-3);  // divides both
  EXPECT_THROW(read("deck.xml", {open, "Grid/Upper={20, 40.01}"}), DeckError);
  EXPECT_THROW(read("deck.xml", {open, "Grid/Upper={20, -40}"}), DeckError);
  // A forgotten unit: refused for the number of its cells, by build_scene, and at once.
  const std::string thin = "Jet/Cells Per Radius=1e15";
  EXPECT_LT(read("deck.xml", {open, thin}).number("Grid/Cell Size"), 1e-12);
}

TEST_F(ReadDeck, WhatAFidelityChoseIsLeftOutWhereItDoesNotWork) {
  const Scene scene = build_scene(read("deck.xml", {"Fidelity=balanced", "Step/Transfer=XPIC"}));
  EXPECT_EQ(scene.step.subcycles, 1);
  EXPECT_TRUE(scene.grid.level_of_tile.empty());
  ASSERT_EQ(scene.left_out.size(), 2U);
  EXPECT_EQ(
      scene.left_out[0],
      "The fidelity's Jet/Cells Per Radius is left out: Step/Transfer = XPIC does not work across "
      "cells of different sizes yet."
  );
  const std::vector<std::string> own = {
      "Fidelity=balanced", "Step/Transfer=XPIC", "Step/Subcycles=2"};
  EXPECT_THROW(build_scene(read("deck.xml", own)), DeckError);
}

TEST_F(ReadDeck, TheDecksOwnWordsComeBeforeAFidelity) {
  const std::vector<std::string> words = {
      "Fidelity=reference",
      "Step/Courant Fraction=0.30",
      "Bodies/Front/Particles Per Cell=4",
      "Output/History Interval=0.02",  // us; the fidelity's 2e-08 s
      "Materials/Rock/Card=berea_sandstone.xml"};
  const Deck deck = read("deck.xml", words);
  EXPECT_EQ(deck.number("Step/Courant Fraction"), 0.3);
  EXPECT_EQ(deck.integer("Bodies/Front/Particles Per Cell"), 4);
  EXPECT_EQ(deck.integer("Bodies/Back/Particles Per Cell"), 2);
  EXPECT_EQ(deck.number("Materials/Rock/Tolerance"), 1e-3);
  EXPECT_TRUE(notes_say(
      deck,
      "The deck's own values take precedence over fidelity reference: Step/Courant Fraction = 0.30 "
      "(reference: 0.8), Bodies/Front/Particles Per Cell = 4 (reference: 2)."
  ));
  EXPECT_TRUE(notes_say(deck, "Output/History Interval = 2e-08 s, "));
}

TEST_F(ReadDeck, TheEffectiveDeckOfAFidelityIsTheSameDeck) {
  const Deck deck = read("deck.xml", {"Fidelity=fast", "Materials/Rock/Card=berea_sandstone.xml"});
  write("effective.xml", effective_deck_xml(deck));
  const Deck again = read("effective.xml");
  EXPECT_EQ(again.values(), deck.values());
  EXPECT_EQ(again.word("Fidelity"), "fast");
  EXPECT_FALSE(notes_say(again, "The deck's own words"));
  EXPECT_THROW(read("deck.xml", {"Fidelity=quick"}), DeckError);
}

TEST_F(ReadDeck, MemoryIsEstimatedFromTheScene) {
  const Scene scene = build_scene(read("deck.xml"));
  EXPECT_GT(particle_estimate(scene), 4.0 * 300.0);
  EXPECT_GT(memory_estimate(scene), 200.0 * 4.0 * 300.0);
  EXPECT_THROW(build_scene(read("deck.xml", {"Grid/Cell Size=1 nm"})), DeckError);
  // In two dimensions the memory goes with the square of the cell size.
  const double times = 2.5 * machine_bytes() / memory_estimate(scene);
  const double parts = std::ceil(std::sqrt(times));  // of a millimetre
  try {
    build_scene(read("deck.xml", {"Grid/Cell Size=" + input::exact_text(1.0 / parts)}));
    FAIL() << "a run of 2.5 times the memory was not refused";
  } catch (const DeckError& error) {
    EXPECT_NE(
        std::string(error.what()).find("or ranks on 3 machines of this size."), std::string::npos
    ) << error.what();
  }
}

TEST_F(ReadDeck, MemoryOfAllMachinesCounts) {
  const Scene scene = build_scene(read("deck.xml"));
  const double parts = std::ceil(std::sqrt(2.5 * machine_bytes() / memory_estimate(scene)));
  const auto build = [&] {
    return build_scene(read("deck.xml", {"Grid/Cell Size=" + input::exact_text(1.0 / parts)}));
  };
  set_machines(2);
  EXPECT_THROW(build(), DeckError);
  set_machines(3);
  EXPECT_NO_THROW(build());
  set_machines(1);
}

TEST(TableOfPressures, IsLinearBetweenAndConstantOutside) {
  const Table table{{1.0, 3.0}, {10.0, 20.0}};
  EXPECT_EQ(table(0.0), 10.0);
  EXPECT_EQ(table(2.0), 15.0);
  EXPECT_EQ(table(3.0), 20.0);
  EXPECT_EQ(table(9.0), 20.0);
}

/// Every entry: a meaning, a default that its own rules accept, no name twice.
void check_section(const input::Section& section) {
  std::set<std::string> names;
  EXPECT_FALSE(section.meaning.empty()) << section.name;
  for (const input::Entry& entry : section.entries) {
    EXPECT_FALSE(entry.meaning.empty()) << entry.name;
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
  }
  for (const auto& part : section.sections) check_section(part);
  for (const auto& part : section.named) check_section(part);
}

TEST(Schema, TablesAreSound) {
  check_section(deck_schema());
  for (const ModelDescription& model : describe_models()) {
    check_section(material_section(model));
    EXPECT_NE(describe_text(model.name).find(model.summary), std::string::npos);
    EXPECT_NO_THROW(valid_parameters(model));
  }
}

/// Where what a sentence suggests begins and ends.
const std::string suggestion = "add <Parameter ";

/// Adds what the sentences suggest until nothing is missing. Whatever they suggest is accepted.
void follow_suggestions(const input::Section& section) {
  std::string body;
  for (std::size_t turn = 0; turn <= section.entries.size(); ++turn) {
    const auto xml =
        input::parse_xml("<ParameterList name=\"t\">" + body + "</ParameterList>", "t");
    input::Section alone = section;
    alone.sections.clear();
    try {
      input::scan_list(xml, alone, "", {"t", {}});
      break;
    } catch (const InputError& error) {
      const std::string said = error.what();
      const std::size_t at = said.find(suggestion);
      ASSERT_NE(at, std::string::npos) << section.name << ": " << said;
      body += said.substr(at + 4, said.rfind("/>") + 2 - at - 4);
    }
  }
  for (const auto& part : section.sections)
    if (!part.read_elsewhere) follow_suggestions(part);
  for (const auto& part : section.named) follow_suggestions(part);
}

TEST(Schema, WhatSentencesSuggestIsAccepted) {
  follow_suggestions(deck_schema());
  for (const ModelDescription& model : describe_models())
    follow_suggestions(material_section(model));
}

TEST_F(ReadDeck, TheSchemaVersionThatIsSuggestedIsTheOneThatIsRead) {
  try {
    read("deck.xml", {"Schema Version="});
    FAIL() << "a deck without its version was read";
  } catch (const DeckError& error) {
    const std::string said = error.what();
    const std::string value = "value=\"" + std::to_string(deck_schema_version) + "\"/>";
    EXPECT_NE(said.find("Schema Version is missing"), std::string::npos) << said;
    EXPECT_NE(said.find(value), std::string::npos) << said;
  }
}

TEST(Schema, TheManualNamesEverySection) {
  const std::string manual = describe_markdown();
  for (const auto& section : deck_schema().sections) {
    EXPECT_NE(manual.find("## " + section.name), std::string::npos) << section.name;
    EXPECT_NO_THROW(describe_text(section.name));
  }
  EXPECT_THROW(describe_text("Girds"), DeckError);
}

TEST(Registry, AListIsCheckedLikeACard) {
  Teuchos::ParameterList list;
  list.set("Model", "Linear Elastic");
  list.set("Density", 1000.0);
  list.set("Bulk Modulus", 6e6);
  EXPECT_THROW(make_material("Rubber", list), InputError);
  list.set("Shear Modulus", 3e6);
  EXPECT_EQ(make_material("Rubber", list).density, 1000.0);
  list.set("Shear Modulis", 3e6);
  EXPECT_THROW(make_material("Rubber", list), InputError);
}

}  // namespace
}  // namespace barreno
