// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

namespace barreno {

/// Names and values of a list of a deck as one text, by which lists of two decks are compared.
/// @param path   of the list
/// @param names  of the entries that count; empty: all
std::string list_text(
    const Deck& deck, const std::string& path, const std::vector<std::string>& names = {}
);

}  // namespace barreno
