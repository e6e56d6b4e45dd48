// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>
#include <vector>

namespace barreno::fuzz {

using Engine = std::mt19937_64;

/// The same on every machine, which the distributions of the library are not.
inline std::size_t below(Engine& engine, std::size_t count) {
  return count == 0 ? 0 : static_cast<std::size_t>(engine() % count);
}
inline bool one_in(Engine& engine, std::size_t count) {
  return below(engine, count) == 0;
}
template <class Values>
const auto& any_of(Engine& engine, const Values& values) {
  return values[below(engine, values.size())];
}

/// Every parameter that a deck or a card knows, with a value that suits its kind.
struct Known {
  std::string name, value;
};
const std::vector<Known>& known_parameters();

/// A number at some edge: of doubles, of integers, of what is a number at all.
std::string odd_number(Engine& engine);
/// Something that no user writes on purpose: odd numbers, words of other places, paths of traps,
/// very long texts.
std::string odd_value(Engine& engine);
/// The value with something changed: a number in it, a bracket, a component.
std::string changed_value(const std::string& value, Engine& engine);
/// Bytes flipped, cut, doubled, put in.
std::string changed_bytes(const std::string& bytes, Engine& engine);

}  // namespace barreno::fuzz
