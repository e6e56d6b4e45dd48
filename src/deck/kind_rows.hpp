// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/words.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace barreno {

/// A table of kinds describes an enumeration that a deck chooses from. Each value has one row with
/// its `kind`, its `word` in decks, its `meaning` for the manual, and what the code asks of it. The
/// rows stand in the order of the enumeration.

template <class Row, std::size_t N>
constexpr bool are_in_order(const std::array<Row, N>& rows) {
  for (std::size_t i = 0; i < N; ++i)
    if (static_cast<std::size_t>(rows[i].kind) != i) return false;
  return true;
}

template <class Row, std::size_t N>
constexpr const Row& row_of(const std::array<Row, N>& rows, decltype(Row::kind) kind) {
  return rows[static_cast<std::size_t>(kind)];
}

template <class Row, std::size_t N>
Words<decltype(Row::kind)> words_of_rows(const std::array<Row, N>& rows) {
  Words<decltype(Row::kind)> words;
  for (const Row& row : rows) words.push_back({row.word, row.kind});
  return words;
}

/// "word: meaning; word: meaning"
template <class Row, std::size_t N>
std::string meanings_of(const std::array<Row, N>& rows) {
  std::string text;
  for (const Row& row : rows) {
    if (!text.empty()) text += "; ";
    text.append(row.word).append(": ").append(row.meaning);
  }
  return text;
}

}  // namespace barreno
