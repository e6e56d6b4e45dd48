// SPDX-License-Identifier: BSD-3-Clause
#include "deck/describe_words.hpp"

#include "deck/deck_schema.hpp"
#include "deck/search_words.hpp"

#include <barreno/input/scan_xml.hpp>

namespace barreno {
namespace {

void place(
    const input::Section& section, const std::string& path, std::vector<PlacedSection>& placed
) {
  placed.push_back({path, &section});
  for (const input::Section& part : section.sections)
    place(part, input::join(path, part.name), placed);
  for (const input::Section& named : section.named)
    place(named, input::join(path, named.name), placed);
}

/// The first name of a path, which is taken off it.
std::string next_name(std::string& path) {
  const std::size_t slash = path.find('/');
  std::string name = path.substr(0, slash);
  path = slash == std::string::npos ? "" : path.substr(slash + 1);
  return name;
}

}  // namespace

std::vector<PlacedSection> placed_sections() {
  std::vector<PlacedSection> placed;
  for (const input::Section& section : deck_schema().sections) place(section, section.name, placed);
  return placed;
}

bool is_meant(const std::string& asked, const std::string& path) {
  if (is_asked(asked, path.substr(path.rfind('/') + 1))) return asked != "*";
  std::string left = asked, right = path;
  while (!left.empty() && !right.empty()) {
    const std::string name = next_name(right);
    if (!is_asked(next_name(left), name) && name != "*") return false;
  }
  return left.empty() && right.empty() && !asked.empty();
}

}  // namespace barreno
