// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// Path of a card, whose name may leave .xml out: beside the deck, then in the project's
/// materials/cards (source tree, then installed), then in the directories of BARRENO_MATERIALS,
/// which ':' separates. Throws FileError with the part of the sentence after the value, nearest
/// name included.
/// @param beside  what the first directory is to the user
std::string find_card(
    const std::string& card,
    const std::string& deck_directory,
    const std::string& beside = "beside the deck"
);

}  // namespace barreno
