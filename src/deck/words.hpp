// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno {

/// A word of the deck and the value that it means. An enumeration that a deck chooses from has
/// a function words_of beside it, which is the only place that spells them.
template <class T>
struct Word {
  const char* word;
  T value;
};
template <class T>
using Words = std::vector<Word<T>>;

template <class T>
std::string spelling(const T& value, const Words<T>& words) {
  for (const Word<T>& each : words)
    if (each.value == value) return each.word;
  return {};
}

template <class T>
std::vector<std::string> spelled(const Words<T>& words) {
  std::vector<std::string> all;
  for (const Word<T>& each : words) all.emplace_back(each.word);
  return all;
}

/// The deck's word for a value of such an enumeration, and all of them.
template <class E>
std::string word_of(E value) {
  return spelling(value, words_of(value));
}
template <class E>
std::vector<std::string> all_words() {
  return spelled(words_of(E{}));
}

}  // namespace barreno
