// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace barreno {

class Deck;

/// Warnings of one material's values, in SI: those outside the usual range of their parameter, and
/// a fluid in pores whose mass the density seems to leave out. A sentence each.
/// @param path  of the material in the deck, for sentences
std::vector<std::string> material_notes(
    const Teuchos::ParameterList& values, const std::string& path
);

/// Those of all materials of a deck.
std::vector<std::string> material_notes(const Deck& deck);

}  // namespace barreno
