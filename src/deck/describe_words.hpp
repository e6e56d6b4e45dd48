// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>
#include <string>
#include <vector>

namespace barreno {

/// A section of the deck and its path, with * for a list of free name: "Pore Flow/Rocks/*".
struct PlacedSection {
  std::string path;
  const input::Section* section;
};

/// Every section that a deck may have, outer before inner ones, in the order of docs/deck.md.
std::vector<PlacedSection> placed_sections();

/// Whether a user who asks for `asked` means what lies at `path`: its whole path, with any name in
/// place of a *, or its last name alone ("Rocks", "Permeability"); small letters stand for letters
/// of any case.
bool is_meant(const std::string& asked, const std::string& path);

}  // namespace barreno
