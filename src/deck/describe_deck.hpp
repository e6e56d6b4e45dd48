// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno {

/// The deck reference out of the tables that validate, as plain text for the screen.
/// @param name  "" for the overview; else a section of the deck ("Grid", "Pore Flow/Rocks"), a
///              model ("Arenisca"), a parameter or history variable ("Permeability"), or a word of
///              a run's files ("channel_depth"), all places of which are described
/// @throws DeckError  for an unknown name, with the nearest one
std::string describe_text(const std::string& name);

/// The whole reference as Markdown: docs/deck.md.
std::string describe_markdown();

/// "a, b, c"
std::string with_commas(const std::vector<std::string>& words);

}  // namespace barreno
