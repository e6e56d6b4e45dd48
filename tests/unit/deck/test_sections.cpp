// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "deck/deck_schema.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/body_force_section.hpp"
#include "deck/sections/body_section.hpp"
#include "deck/sections/contact_section.hpp"
#include "deck/sections/continue_section.hpp"
#include "deck/sections/detonation_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/head_section.hpp"
#include "deck/sections/jet_monitor_section.hpp"
#include "deck/sections/jet_profile_section.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/load_sections.hpp"
#include "deck/sections/material_section.hpp"
#include "deck/sections/output_section.hpp"
#include "deck/sections/pore_flow_section.hpp"
#include "deck/sections/quasi_static_section.hpp"
#include "deck/sections/refinement_section.hpp"
#include "deck/sections/shape_section.hpp"
#include "deck/sections/step_section.hpp"
#include "deck/sections/time_section.hpp"

#include <gtest/gtest.h>

#include <barreno/input/scan_xml.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace barreno {
namespace {

const input::UnitSystem si = input::Source{}.units;

/// The list of a section, or one of its lists of free name.
template <class Spec>
std::string list_path() {
  const SectionTable<Spec>& table = table_of<Spec>();
  return table.each.empty() ? table.path : list_of<Spec>("One");
}

Teuchos::ParameterList& sublist(Teuchos::ParameterList& values, const std::string& path) {
  if (path.empty()) return values;
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return values.sublist(path);
  return sublist(values.sublist(path.substr(0, slash)), path.substr(slash + 1));
}

/// A deck in three dimensions that says one entry of a section and nothing else.
template <class Spec>
Deck deck_with(const input::Entry& entry, const std::string& text) {
  Teuchos::ParameterList values;
  values.sublist("Grid").set("Mode", std::string("3D"));
  values.sublist("Materials").sublist("First");
  values.sublist("Materials").sublist("Second");
  input::put_value(sublist(values, list_path<Spec>()), entry, text, si);
  return {"deck.xml", values, Teuchos::XMLObject("ParameterList")};
}

/// Values of every kind as the tables print them.
std::vector<std::string> values_for(const input::Entry& entry) {
  if (entry.kind == input::Kind::table)
    return {entry.columns.size() == 3 ? "1x3:{1, 2, 3}" : "1x2:{1, 2}"};
  std::vector<std::string> values = {
      "Second", "0.25", "1.5", "5e-07", "3", "true", "false", "{1, 2, 3}"};
  values.insert(values.end(), entry.words.begin(), entry.words.end());
  for (const std::string& word : entry.words) values.push_back("{" + word + "}");
  return values;
}

/// A value of the entry that is not what the struct holds before anything is read.
template <class Spec>
std::string other_value(const BoundEntry<Spec>& bound) {
  for (const std::string& value : values_for(bound.entry)) {
    Teuchos::ParameterList list;
    try {
      input::put_value(list, bound.entry, value, si);
    } catch (const InputError&) {
      continue;
    }
    if (value == bound.text(Spec{})) continue;
    return bound.entry.name == "Mode" ? "3D" : value;  // the mode of the deck of these tests
  }
  ADD_FAILURE() << "no value for " << bound.entry.name;
  return {};
}

template <class Spec>
class ASection : public ::testing::Test {};
using All = ::testing::Types<
    HeadSection,
    GridSpec,
    MaterialSection,
    RefinedRegion,
    ShapeSection,
    BodySpec,
    MotionSpec,
    ConditionSpec,
    PressureLoadSpec,
    ConfinementSection,
    JetSpec,
    JetProfileSpec,
    JetMonitorSpec,
    DetonationSpec,
    DetonatorSpec,
    BodyForceSpec,
    ContactSpec,
    ContinueSpec,
    PoreFlowSpec,
    PermeabilitySpec,
    PoreConditionSpec,
    StepSpec,
    QuasiStaticSection,
    TimeSpec,
    OutputSpec>;
TYPED_TEST_SUITE(ASection, All);

TYPED_TEST(ASection, AnEntryFillsItsOwnMemberAndNoOther) {
  const auto& entries = table_of<TypeParam>().entries;
  for (const auto& bound : entries) {
    if (!bound.read) continue;
    SCOPED_TRACE(bound.entry.name);
    const std::string value = other_value(bound);
    const Deck deck = deck_with<TypeParam>(bound.entry, value);
    const auto spec = read_list<TypeParam>(deck, list_path<TypeParam>());
    if (bound.read_by.empty()) {
      EXPECT_EQ(bound.text(spec), value);
    }
    EXPECT_NE(bound.text(spec), bound.text(TypeParam{}));
    for (const auto& other : entries) {
      if (!other.read || &other == &bound || other.entry.name == "Mode") continue;
      EXPECT_EQ(other.text(spec), other.text(TypeParam{})) << "changed " << other.entry.name;
    }
  }
}

TYPED_TEST(ASection, ADefaultIsWhatTheStructHolds) {
  for (const auto& bound : table_of<TypeParam>().entries) {
    if (!bound.read || bound.entry.presence != input::Presence::defaulted) continue;
    SCOPED_TRACE(bound.entry.name);
    const Deck deck = deck_with<TypeParam>(bound.entry, bound.entry.default_text);
    const auto spec = read_list<TypeParam>(deck, list_path<TypeParam>());
    EXPECT_EQ(bound.text(spec), bound.text(TypeParam{}));
  }
}

using ByFunction = std::map<std::string, std::string>;  ///< path of an entry: its function

/// What the tables list; "bound" where no function is named.
template <class Spec>
void list_entries(ByFunction& all) {
  const SectionTable<Spec>& table = table_of<Spec>();
  for (const auto& bound : table.entries) {
    const std::string path = table.each.empty() ? table.path : table.path + "/*";
    all[input::join(path, bound.entry.name)] = bound.read_by.empty() ? "bound" : bound.read_by;
    EXPECT_TRUE(bound.read || !bound.read_by.empty()) << path << " " << bound.entry.name;
  }
}
template <class... Specs>
ByFunction listed(const ::testing::Types<Specs...>& /*of*/) {
  ByFunction all;
  (list_entries<Specs>(all), ...);
  return all;
}

/// What the schema holds.
void add_paths(const input::Section& section, const std::string& path, std::set<std::string>& all) {
  for (const input::Entry& entry : section.entries) all.insert(input::join(path, entry.name));
  for (const input::Section& part : section.sections)
    add_paths(part, input::join(path, part.name), all);
  for (const input::Section& named : section.named) add_paths(named, path + "/*", all);
}

/// Of the entries of bodies and refined regions those of their shapes stand in the table of Shapes.
std::string table_path(const std::string& path, const ByFunction& tables) {
  for (const std::string shaped : {"Bodies/*/", "Refinement/*/"})
    if (path.rfind(shaped, 0) == 0 && tables.count(path) == 0)
      return "Shapes/*/" + path.substr(shaped.size());
  return path;
}

TEST(Sections, EveryEntryOfTheSchemaIsBoundOrReadByANamedFunction) {
  const ByFunction tables = listed(All{});
  std::set<std::string> schema;
  add_paths(deck_schema(), "", schema);
  ByFunction by_function;
  for (const std::string& path : schema) {
    const auto found = tables.find(table_path(path, tables));
    if (found == tables.end())
      ADD_FAILURE() << path << " is in no table";
    else if (found->second != "bound")
      by_function.insert(*found);
  }
  for (const auto& [path, function] : tables)
    EXPECT_EQ(schema.count(path), 1u) << path << " is in a table, but in no deck";
  const ByFunction expected = {
      {"Bodies/*/Material", "material_at"},
      {"Bodies/*/Motion Factors", "read_factors"},
      {"Bodies/*/Motion Times", "read_factors"},
      {"Conditions/*/Factors", "read_factors"},
      {"Conditions/*/Times", "read_factors"},
      {"Contact/*/Material", "pair_at"},
      {"Contact/*/Other Material", "pair_at"},
      {"Jet/Material", "material_at"},
      {"Jet/Slugs", "table_slugs"},
      {"Jet/Table", "include_jet_table"},
      {"Loads/*/Body", "body_named"},
      {"Loads/*/Faces", "read_faces"},
      {"Loads/*/Pressure", "read_pressure"},
      {"Loads/*/Pressures", "read_pressure"},
      {"Loads/*/Surfaces", "read_surfaces"},
      {"Loads/*/Times", "read_pressure"},
      {"Pore Flow/Conditions/*/Flux", "read_flux"},
      {"Pore Flow/Conditions/*/Pressure", "read_pressure"},
      {"Pore Flow/Conditions/*/Pressures", "read_pressure"},
      {"Pore Flow/Conditions/*/Times", "read_pressure"},
      {"Pore Flow/Rocks/*/Permeability", "read_permeability"}};
  EXPECT_EQ(by_function, expected);
}

}  // namespace
}  // namespace barreno
