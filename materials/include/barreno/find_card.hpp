// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// A model with its parameters: barreno/models.hpp.
struct Material;

/// File of a card that a user or a host names; with or without ".xml".
///
/// Searched: the name as a path from `directory`; then the directories of the environment variable
/// BARRENO_MATERIALS (':' between them); then the cards that Barreno comes with (beside the library
/// or program, in the source tree, in the installation). In the last two the case of letters does
/// not count, because hosts write names in upper case; the same case goes first.
///
/// Throws FileError with the part of a sentence after the name, the nearest name included.
/// @param beside  how a message names that directory
std::string find_card(
    const std::string& card,
    const std::string& directory = "",
    const std::string& beside = "in the working directory"
);

/// The same for a host: from the working directory, and FileError carries the whole sentence.
std::string named_card(const std::string& card);

/// The material of a card by path or by name, material_open("berea_sandstone"): what
/// barreno_material_open() is in C and --material in `barreno drive`.
///
/// Throws FileError if there is no such card or it cannot be read, InputError if its contents are
/// wrong.
Material material_open(const std::string& card);

}  // namespace barreno
