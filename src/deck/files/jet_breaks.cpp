// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/jet_breaks.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/material_section.hpp"

#include <barreno/input/scan_xml.hpp>
#include <cstdlib>
#include <optional>
#include <vector>

namespace barreno {
namespace {

using Teuchos::XMLObject;

/// The lists that say what a material is, the deck's own before its card; empty where there is none
/// of that name.
std::vector<XMLObject> lists_of_material(
    const XMLObject& root, const std::string& name, const ParsedCard& parsed_card
) {
  const std::string& path = table_of<MaterialSection>().path;
  const auto materials = input::find_list(root, path);
  const auto own = materials ? input::find_list(*materials, name) : std::nullopt;
  if (!own) return {};
  std::vector<XMLObject> lists{*own};
  if (const auto card = input::find_text(*own, name_of(&MaterialSection::card)))
    lists.push_back(parsed_card(*card, input::join(path, name)));
  return lists;
}

}  // namespace

bool jet_breaks(const XMLObject& root, const ParsedCard& parsed_card) {
  const auto jet = input::find_list(root, table_of<JetSpec>().path);
  const auto material = jet ? input::find_text(*jet, "Material") : std::nullopt;
  if (!material) return false;
  const std::vector<XMLObject> lists = lists_of_material(root, *material, parsed_card);
  for (const char* name : {"Spall Stress", "D1", "D2", "D3", "D4", "D5"})
    for (const XMLObject& list : lists)
      if (const auto text = input::find_text(list, name)) {
        if (std::strtod(text->c_str(), nullptr) != 0.0) return true;
        break;  // the first says it
      }
  return false;
}

}  // namespace barreno
