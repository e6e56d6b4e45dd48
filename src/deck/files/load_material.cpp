// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/load_material.hpp"

#include "base/error.hpp"
#include "deck/files/assumptions_of.hpp"
#include "deck/files/read_on_root.hpp"

#include <barreno/find_card.hpp>
#include <barreno/input/scan_xml.hpp>
#include <barreno/registry.hpp>
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
