// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace barreno::fuzz {

/// What reads the files of a user.
enum class Reader { deck, card, jet, path, surface };
inline constexpr int reader_count = 5;
const char* name_of(Reader reader);

/// The reader of a file, by its ending, its folder and its header.
Reader reader_of(const std::filesystem::path& file, const std::string& bytes);

struct Answer {
  bool accepted = false;
  std::string sentence;  ///< of the refusal
  std::string fault;     ///< what is wrong with that sentence, or with the error; mostly nothing
};

/// A folder with the files that decks name beside each other, and traps: a pipe, a device, a
/// folder, a file of a gigabyte.
void prepare_folder(const std::filesystem::path& folder);

/// The bytes as a file in that folder, on the way that they go in the program: a deck is read with
/// all that it names, checked, and becomes a scene.
Answer read_input(Reader reader, const std::string& bytes, const std::filesystem::path& folder);

}  // namespace barreno::fuzz
