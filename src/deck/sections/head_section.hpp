// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"

#include <optional>
#include <string>

namespace barreno {

/// What stands at the top of a deck.
struct HeadSection {
  int schema_version = 0;
  std::string title;
  std::string units = "SI";
  std::optional<std::string> fidelity;
};
template <>
const SectionTable<HeadSection>& table_of<HeadSection>();

/// What --set takes to choose a fidelity: "Fidelity=fast".
std::string fidelity_override(const std::string& fidelity);

}  // namespace barreno
