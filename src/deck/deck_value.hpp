// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "deck/face.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

#include <barreno/input/scan_xml.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace barreno {

/// The value of a deck's word, which is one of these.
template <class T>
T value_at(const Deck& deck, const std::string& path, const Words<T>& words) {
  const std::string word = deck.word(path);
  for (const Word<T>& each : words)
    if (word == each.word) return each.value;
  throw std::logic_error("no value for the word at " + path);
}

/// How the type of a struct's member stands in a deck: the entry that it makes, value of a deck
/// that was read, text of a value in SI.
template <class T, class = void>
struct DeckValue;

template <>
struct DeckValue<double> {
  static constexpr input::Kind kind = input::Kind::number;
  static input::Entry entry(
      const char* name, const Dimension& dimension, const Bounds& bounds, const std::string& meaning
  ) {
    return input::number(name, dimension, bounds, meaning);
  }
  static double read(const Deck& deck, const std::string& path) { return deck.number(path); }
  static std::string text(double x) { return input::exact_text(x); }
};

template <class T>
struct DeckValue<T, std::enable_if_t<std::is_same_v<T, int> || std::is_same_v<T, long>>> {
  static constexpr input::Kind kind = input::Kind::integer;
  static input::Entry entry(const char* name, const Bounds& bounds, const std::string& meaning) {
    return input::integer(name, bounds, meaning);
  }
  static T read(const Deck& deck, const std::string& path) { return deck.integer(path); }
  static std::string text(T x) { return std::to_string(x); }
};

template <>
struct DeckValue<bool> {
  static constexpr input::Kind kind = input::Kind::flag;
  static input::Entry entry(const char* name, const std::string& meaning) {
    return input::flag(name, meaning);
  }
  static bool read(const Deck& deck, const std::string& path) { return deck.flag(path); }
  static std::string text(bool x) { return x ? "true" : "false"; }
};

template <>
struct DeckValue<std::string> {
  static constexpr input::Kind kind = input::Kind::text;
  static input::Entry entry(const char* name, const std::string& meaning) {
    return input::text(name, meaning);
  }
  static std::string read(const Deck& deck, const std::string& path) { return deck.word(path); }
  static std::string text(const std::string& x) { return x; }
};

template <class E>
struct DeckValue<E, std::enable_if_t<std::is_enum_v<E>>> {
  static constexpr input::Kind kind = input::Kind::word;
  static input::Entry entry(const char* name, const std::string& meaning) {
    return input::word(name, all_words<E>(), meaning);
  }
  static E read(const Deck& deck, const std::string& path) {
    return value_at(deck, path, words_of(E{}));
  }
  static std::string text(E x) { return word_of(x); }
};

/// Of the deck's mode.
template <>
struct DeckValue<Face> {
  static constexpr input::Kind kind = input::Kind::word;
  static input::Entry entry(const char* name, const std::string& meaning) {
    return input::word(name, all_words<Face>(), meaning);
  }
  static Face read(const Deck& deck, const std::string& path) {
    return face_at(deck, path, deck.word(path));
  }
  static std::string text(Face x) { return word_of(x); }
};
template <>
struct DeckValue<FaceSet> {
  static constexpr input::Kind kind = input::Kind::words;
  static input::Entry entry(const char* name, const std::string& meaning) {
    return input::words(name, all_words<Face>(), meaning);
  }
  static FaceSet read(const Deck& deck, const std::string& path) {
    FaceSet faces{};
    for (const std::string& word : deck.words(path))
      faces[static_cast<std::size_t>(face_at(deck, path, word))] = true;
    return faces;
  }
  static std::string text(const FaceSet& x) {
    std::string text;
    for (const Word<Face>& each : words_of(Face{}))
      if (x[static_cast<std::size_t>(each.value)])
        text += (text.empty() ? "" : ", ") + std::string(each.word);
    return "{" + text + "}";
  }
};

/// One component for each dimension of the deck's mode.
template <>
struct DeckValue<Vector> {
  static constexpr input::Kind kind = input::Kind::vector;
  static input::Entry entry(
      const char* name, const Dimension& dimension, const Bounds& bounds, const std::string& meaning
  ) {
    return input::vector(name, dimension, bounds, meaning);
  }
  static Vector read(const Deck& deck, const std::string& path) { return vector_at(deck, path); }
  static std::string text(const Vector& x) {
    return "{" + input::exact_text(x[0]) + ", " + input::exact_text(x[1]) + ", " +
           input::exact_text(x[2]) + "}";
  }
};

template <>
struct DeckValue<std::vector<std::string>> {
  static constexpr input::Kind kind = input::Kind::words;
  static input::Entry entry(const char* name, const std::string& meaning) {
    return input::words(name, {}, meaning);
  }
  static std::vector<std::string> read(const Deck& deck, const std::string& path) {
    return deck.words(path);
  }
  static std::string text(const std::vector<std::string>& x) {
    std::string text;
    for (const std::string& each : x) text += (text.empty() ? "" : ", ") + each;
    return "{" + text + "}";
  }
};

template <>
struct DeckValue<std::vector<std::vector<double>>> {
  static constexpr input::Kind kind = input::Kind::table;
  static input::Entry entry(
      const char* name, const std::vector<Dimension>& columns, const std::string& meaning
  ) {
    return input::table(name, columns, meaning);
  }
  static std::vector<std::vector<double>> read(const Deck& deck, const std::string& path) {
    return deck.rows(path);
  }
  static std::string text(const std::vector<std::vector<double>>& x) {
    std::string values;
    for (const auto& row : x)
      for (const double value : row)
        values += (values.empty() ? "" : ", ") + input::exact_text(value);
    const std::size_t columns = x.empty() ? 0 : x.front().size();
    return std::to_string(x.size()) + "x" + std::to_string(columns) + ":{" + values + "}";
  }
};

/// What a deck may leave out without a default.
template <class T>
struct DeckValue<std::optional<T>> {
  static constexpr input::Kind kind = DeckValue<T>::kind;
  template <class... What>
  static input::Entry entry(const What&... what) {
    return DeckValue<T>::entry(what...);
  }
  static std::optional<T> read(const Deck& deck, const std::string& path) {
    return DeckValue<T>::read(deck, path);
  }
  static std::string text(const std::optional<T>& x) { return x ? DeckValue<T>::text(*x) : ""; }
};

}  // namespace barreno
