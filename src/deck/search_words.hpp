// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno {

/// A word that users search for and no deck has, where to look for it, and the names to look up.
struct SearchWord {
  std::vector<const char*> words;  ///< in small letters
  const char* answer;              ///< a sentence, with the page
  std::vector<const char*> names;  ///< that describe_text knows
};
const std::vector<SearchWord>& search_words();

/// The entry that has this word, in letters of any case; null if none has.
const SearchWord* find_search_word(const std::string& asked);

/// In small letters.
std::string in_small_letters(std::string text);

/// Whether a name is asked for: as it is written, or in small letters alone.
bool is_asked(const std::string& asked, const std::string& name);

}  // namespace barreno
