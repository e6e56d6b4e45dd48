// SPDX-License-Identifier: BSD-3-Clause
#include "deck/search_words.hpp"

#include <algorithm>
#include <cctype>

namespace barreno {

const std::vector<SearchWord>& search_words() {
  static const std::vector<SearchWord> words = {
      {{"skin", "productivity", "flow efficiency"},
       "A run gives the rock around the hole, from which a flow code computes the skin; a skin "
       "itself is not computed (docs/report.md).",
       {"Permeability", "channel_depth"}},
      {{"hole", "tunnel", "perforation", "perforation tunnel", "entrance hole", "hole size"},
       "The hole's depth and radius over time stand in depth.csv; `barreno report` draws the hole "
       "along its depth (docs/report.md).",
       {"channel_depth", "channel_radius_mid"}},
      {{"penetration", "depth", "depth of penetration"},
       "The depth of the jet over time stands in depth.csv; `barreno converge` tells how far cells "
       "change it (docs/converge.md).",
       {"depth", "channel_depth"}},
      {{"gun", "perforator", "carrier", "charge", "shaped charge", "standoff", "clearance"},
       "A gun is its jet and what lies in front of it: the jet is launched from a table, or forms "
       "from a liner and an explosive; the distance to the target is that from Launch Position to "
       "the first body (docs/jets.md).",
       {"Jet/Launch Position", "Jet/Table", "Detonation", "Jet Monitor"}},
      {{"liner", "explosive", "detonator"},
       "A liner and its explosive are bodies; the explosive is lit by Detonation "
       "(docs/explosives.md).",
       {"Detonation", "JWL Explosive"}},
      {{"casing", "cement", "steel", "rock", "sandstone", "target"},
       "Each is a body with a material; cards of materials lie in materials/cards "
       "(docs/guide/2_deck.md).",
       {"Bodies/*/Material", "Materials/*/Card"}},
      {{"water", "oil", "gas", "fluid", "brine", "saturation", "pore fluid", "wet"},
       "Arenisca rock holds fluid with fluid_B0 (water: 2.2 GPa) and Fluid Density (water: 1000 "
       "kg/m3); it drains with Pore Flow (docs/method.md). A body of liquid takes the card water, "
       "brine or oil (docs/materials/liquids.md).",
       {"fluid_B0", "Fluid Density", "Pore Flow", "Bodies/*/Pore Pressure", "Liquid"}},
      {{"pore pressure", "overburden", "stress", "in-situ stress", "effective stress"},
       "Confinement is the total pressure at the start, Pore Pressure that of the fluid in the "
       "rock "
       "(docs/method.md).",
       {"Confinement", "Bodies/*/Pore Pressure"}},
      {{"darcy", "millidarcy", "md"},
       "Permeability is given in m2: 1 mD = 9.87e-16 m2.",
       {"Permeability"}},
      {{"underbalance", "overbalance", "wellbore", "well"},
       "The pressure in the hole is a condition of the pore flow on its faces (docs/method.md).",
       {"Pore Flow/Conditions"}},
      {{"mesh", "element size", "resolution"},
       "Cells are of Cell Size, and smaller where a Refinement or Cells Per Radius says so "
       "(docs/trade.md).",
       {"Cell Size", "Cells Per Radius"}},
      {{"time step", "timestep", "dt", "cfl"},
       "The step follows from cells and speeds; Courant Fraction and Largest Step limit it "
       "(docs/method.md, 4).",
       {"Courant Fraction", "Largest Step"}},
      {{"friction"},
       "Friction acts between bodies that Contact names (docs/method.md).",
       {"Contact"}},
      {{"unit", "psi", "ksi", "si"},
       "A number may carry its unit, \"12.7 mm\", \"10 ksi\"; plain numbers are in Units.",
       {"Units"}}};
  return words;
}

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

const SearchWord* find_search_word(const std::string& asked) {
  std::string word = in_small_letters(asked);
  const auto has = [](const SearchWord& each, const std::string& text) {
    return std::find(each.words.begin(), each.words.end(), text) != each.words.end();
  };
  for (int attempt = 0; attempt < 2; ++attempt) {
    for (const SearchWord& each : search_words())
      if (has(each, word)) return &each;
    if (word.size() < 4 || word.back() != 's') return nullptr;
    word.pop_back();  // of several
  }
  return nullptr;
}

bool is_asked(const std::string& asked, const std::string& name) {
  return asked == name || (asked == in_small_letters(asked) && asked == in_small_letters(name));
}

}  // namespace barreno
