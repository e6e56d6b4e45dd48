// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/material_section.hpp"

#include "deck/section_table.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<MaterialSection> material_table() {
  return {
      "Materials",
      "what the bodies are made of, one freely named list each",
      Presence::required,
      {if_given(
           &MaterialSection::card,
           file(
               "Card",
               "file of a card, with or without .xml: beside the deck, in BARRENO_MATERIALS or in "
               "materials/cards"
           )
       ),
       defaulted(
           &MaterialSection::bad_particles,
           "Bad Particles",
           "what happens to a particle whose update fails, that expands too far or is inverted; "
           "one that leaves the grid is always removed"
       ),
       if_given(
           &MaterialSection::largest_expansion,
           "Largest Expansion",
           dim::none,
           above(1.0),
           "V / V_ref beyond which a particle of this material counts as bad; without it 100 for "
           "explosives, else that of Step"
       ),
       if_given(
           &MaterialSection::volume_relaxation,
           "Volume Relaxation",
           dim::none,
           between(0.0, 100.0),
           "rate, per shear strain, at which the particles of a cell that flow take on its mean "
           "volume ratio: smooths pressures that alternate from particle to particle in metal "
           "that has flown; 30 for a casing, without it 0"
       )},
      "one material: a card, a model with its parameters, or a card with single values overridden"};
}

}  // namespace

template <>
const SectionTable<MaterialSection>& table_of<MaterialSection>() {
  static const SectionTable<MaterialSection> table = material_table();
  return table;
}

int material_at(const Deck& deck, const std::string& path) {
  const auto names = deck.lists(table_of<MaterialSection>().path);
  const std::string name = deck.word(path);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    deck.refuse_value(path, "names no list in Materials; " + input::suggest_name(name, names));
  }
  return static_cast<int>(found - names.begin());
}

}  // namespace barreno
