// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno {

/// The deck reference out of the tables that validate, as plain text for the screen.
/// @param section  "" for the overview; else a section of the deck ("Grid") or a model ("Arenisca")
/// @throws DeckError  for an unknown section, with the nearest name
std::string describe_text(const std::string& section);

/// The whole reference as Markdown: docs/deck.md.
std::string describe_markdown();

/// "a, b, c"
std::string with_commas(const std::vector<std::string>& words);

}  // namespace barreno
