// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/assumptions_of.hpp"

#include <barreno/input/scan_xml.hpp>
#include <barreno/registry.hpp>

namespace barreno {

std::vector<std::string> assumptions_of(const Teuchos::XMLObject& card, const std::string& name) {
  std::vector<std::string> notes;
  for (const char* expected : {input::units_word, card_version_word}) {
    if (!input::find_text(card, expected))
      notes.push_back(name + " does not state its " + expected + "; the default is used.");
  }
  return notes;
}

}  // namespace barreno
