// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/head_section.hpp"

#include "deck/deck_schema.hpp"
#include "deck/fidelity.hpp"
#include "deck/section_table.hpp"

#include <barreno/input/units.hpp>

namespace barreno {
namespace {

using namespace input;

SectionTable<HeadSection> head_table() {
  const std::string version = std::to_string(deck_schema_version);
  return {
      "",
      "a run",
      Presence::required,
      {needed(
           &HeadSection::schema_version,
           integer("Schema Version", any(), "version of this table: " + version).such_as(version)
       ),
       defaulted(&HeadSection::title, "Title", "one line for screens and files"),
       defaulted(
           &HeadSection::units,
           units_word,
           "of plain numbers: SI, or units of length, time and mass (\"mm-us-g\")"
       ),
       if_given(
           &HeadSection::fidelity,
           word(
               "Fidelity",
               fidelity_choices(),
               "a set of choices that trade error against cost (" + fidelity_text() +
                   "), for what the deck leaves open; none: no choices; errors were measured for "
                   "the depth of a jet "
                   "with cells of its radius, the pressures of a shock and smooth strains of 0.3: "
                   "docs/trade.md"
           )
       )}};
}

}  // namespace

template <>
const SectionTable<HeadSection>& table_of<HeadSection>() {
  static const SectionTable<HeadSection> table = head_table();
  return table;
}

std::string fidelity_override(const std::string& fidelity) {
  return path_of(&HeadSection::fidelity) + "=" + fidelity;
}

}  // namespace barreno
