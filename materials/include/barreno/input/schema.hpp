// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"

#include <string>
#include <utility>
#include <vector>

namespace barreno::input {

/// What a parameter's text is read as, and what the ParameterList then holds.
enum class Kind {
  number,   ///< double, in SI
  integer,  ///< int; "1e6" is one
  text,     ///< std::string
  word,     ///< std::string out of Entry::words
  words,    ///< Array<std::string> out of Entry::words (none: any names), "{x_upper, y_upper}"
  flag,     ///< bool
  vector,   ///< Array<double>, in SI, "{0 mm, -20 mm}"
  table,    ///< TwoDArray<double>, in SI, "2x3:{...}", a dimension per column
  file      ///< std::string, a path relative to the deck
};

enum class Presence { required, defaulted, optional };

/// One parameter: the single source for validation, default, effective deck and manual.
struct Entry {
  std::string name;
  Kind kind = Kind::number;
  std::string meaning;
  Dimension dimension{};
  Bounds bounds = any();
  Presence presence = Presence::required;
  std::string default_text{};  ///< in SI, as a deck would say it
  /// Kind::word and Kind::words; of Kind::number: words that may stand in its place
  std::vector<std::string> words{};
  std::vector<Dimension> columns{};  ///< Kind::table
  std::string example{};             ///< for sentences; empty: one that suits kind and bounds

  /// The same entry with a default, as a deck in SI would say it.
  Entry by_default(std::string text) const {
    Entry entry = *this;
    entry.presence = Presence::defaulted;
    entry.default_text = std::move(text);
    return entry;
  }
  /// The same entry with a value that sentences may suggest.
  Entry such_as(std::string text) const {
    Entry entry = *this;
    entry.example = std::move(text);
    return entry;
  }
  /// The same number, or this word in its place.
  Entry or_word(std::string text) const {
    Entry entry = *this;
    entry.words.push_back(std::move(text));
    return entry;
  }
  /// The same entry, allowed to be absent; a rule across entries then decides.
  Entry if_given() const {
    Entry entry = *this;
    entry.presence = Presence::optional;
    return entry;
  }
};

inline Entry number(
    std::string name, const Dimension& dimension, const Bounds& bounds, std::string meaning
) {
  return {std::move(name), Kind::number, std::move(meaning), dimension, bounds};
}
inline Entry integer(std::string name, const Bounds& bounds, std::string meaning) {
  return {std::move(name), Kind::integer, std::move(meaning), dimension::none, bounds};
}
inline Entry text(std::string name, std::string meaning) {
  return {std::move(name), Kind::text, std::move(meaning)};
}
inline Entry file(std::string name, std::string meaning) {
  return {std::move(name), Kind::file, std::move(meaning)};
}
inline Entry word(std::string name, std::vector<std::string> words, std::string meaning) {
  Entry entry{std::move(name), Kind::word, std::move(meaning)};
  entry.words = std::move(words);
  return entry;
}
inline Entry words(std::string name, std::vector<std::string> words, std::string meaning) {
  Entry entry = word(std::move(name), std::move(words), std::move(meaning));
  entry.kind = Kind::words;
  return entry;
}
inline Entry flag(std::string name, std::string meaning) {
  return {std::move(name), Kind::flag, std::move(meaning)};
}
/// Bounds apply to every component.
inline Entry vector(
    std::string name, const Dimension& dimension, const Bounds& bounds, std::string meaning
) {
  return {std::move(name), Kind::vector, std::move(meaning), dimension, bounds};
}
inline Entry table(std::string name, std::vector<Dimension> columns, std::string meaning) {
  Entry entry{std::move(name), Kind::table, std::move(meaning)};
  entry.columns = std::move(columns);
  return entry;
}

/// One sub-list: its parameters, its sub-lists of fixed name, or sub-lists of free names
/// ("Bodies/*").
struct Section {
  std::string name;
  std::string meaning;
  Presence presence = Presence::required;  ///< defaulted: filled when absent
  std::vector<Entry> entries;
  std::vector<Section> sections;
  std::vector<Section> named;  ///< none, or one: the table of every sub-list of free name
  /// The sub-lists of free name are left to the caller, because their table depends on what they
  /// hold.
  bool named_read_elsewhere = false;
  /// What is in the list is the business of another library: the caller reads it.
  bool read_elsewhere = false;
};

}  // namespace barreno::input
