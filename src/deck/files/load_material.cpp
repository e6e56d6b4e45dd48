// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/load_material.hpp"

#include "base/error.hpp"
#include "deck/files/read_on_root.hpp"

#include <barreno/find_card.hpp>
#include <barreno/input/scan_xml.hpp>
#include <filesystem>

namespace barreno {
namespace {

std::string load_text(const std::string& card, const Comm& comm) {
  const auto read = [&] {
    std::string file;
    try {
      file = find_card(card);
    } catch (const FileError& error) {
      throw FileError("--material " + input::shown(card) + " " + error.what());
    }
    return read_file(file, input::largest_text, "a card");
  };
  return read_on_root(read, comm);
}

}  // namespace

std::vector<std::string> assumptions_of(const Teuchos::XMLObject& card, const std::string& name) {
  std::vector<std::string> notes;
  for (const char* expected : {"Units", "Schema Version"}) {
    if (!input::find_text(card, expected))
      notes.push_back(name + " does not state its " + expected + "; the default is used.");
  }
  return notes;
}

LoadedMaterial load_material(
    const std::string& card, const std::vector<std::string>& overrides, const Comm& comm
) {
  const std::string text = load_text(card, comm);
  const std::filesystem::path path(card);
  const std::string source = path.filename().string();
  Teuchos::XMLObject xml = input::parse_xml(text, source);
  const std::vector<std::string> notes = assumptions_of(xml, source);
  for (const std::string& assignment : overrides)
    xml = input::override_value(xml, assignment, "\"PEAKI1=20 MPa\"");
  return {make_material(path.stem().string(), scan_card(xml, source), source), notes};
}

}  // namespace barreno
