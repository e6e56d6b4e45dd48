// SPDX-License-Identifier: BSD-3-Clause
#include "mutate.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace barreno::fuzz {
namespace {

constexpr std::size_t largest = 64U << 10U;

using Strings = std::vector<std::string>;

Strings parts_of(const std::string& text, char separator) {
  Strings parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string joined(const Strings& parts, char separator) {
  std::string text;
  for (const std::string& part : parts) text += part + separator;
  text.pop_back();
  return text;
}

/// Parts left out, doubled, exchanged; false: something else is to be done.
bool rearrange(Strings& parts, Engine& engine) {
  const auto at = static_cast<std::ptrdiff_t>(below(engine, parts.size()));
  switch (below(engine, 8)) {
    case 0:
      if (parts.size() > 1) parts.erase(parts.begin() + at);
      return true;
    case 1:
      parts.insert(parts.begin() + at, parts[below(engine, parts.size())]);
      return true;
    case 2:
      std::swap(parts[below(engine, parts.size())], parts[below(engine, parts.size())]);
      return true;
    default:
      return false;
  }
}

float odd_float(Engine& engine) {
  static const std::vector<float> floats = {
      0.0F,
      -0.0F,
      1.0F,
      -1.0F,
      0.5F,
      1e-20F,
      1e30F,
      std::numeric_limits<float>::max(),
      std::numeric_limits<float>::denorm_min(),
      std::numeric_limits<float>::infinity(),
      std::numeric_limits<float>::quiet_NaN()};
  return any_of(engine, floats);
}

template <class Value>
void overwrite(std::string& bytes, std::size_t at, Value value) {
  if (at + sizeof value <= bytes.size()) std::memcpy(bytes.data() + at, &value, sizeof value);
}

std::string changed_once(Reader reader, const std::string& bytes, Engine& engine) {
  if (one_in(engine, 5)) return changed_bytes(bytes, engine);
  if (reader != Reader::surface) return changed_table(bytes, ',', engine);
  const bool text = bytes.compare(0, 5, "solid") == 0;
  return text ? changed_table(bytes, ' ', engine) : changed_binary_surface(bytes, engine);
}

}  // namespace

std::string changed_table(const std::string& text, char separator, Engine& engine) {
  Strings lines = parts_of(text, '\n');
  if (rearrange(lines, engine)) return joined(lines, '\n');
  std::string& line = lines[below(engine, lines.size())];
  Strings cells = parts_of(line, separator);
  if (!rearrange(cells, engine)) {
    std::string& cell = cells[below(engine, cells.size())];
    cell = one_in(engine, 3) ? odd_value(engine) : changed_value(cell, engine);
  }
  line = joined(cells, separator);
  return joined(lines, '\n');
}

std::string changed_binary_surface(const std::string& bytes, Engine& engine) {
  constexpr std::size_t header = 84, facet = 50;
  static const std::vector<std::uint32_t> counts = {
      0, 1, 11, 13, 1000000, 4000000000U, 4294967295U};
  if (bytes.size() < header + facet) return changed_bytes(bytes, engine);
  std::string changed = bytes;
  const std::size_t facets = (bytes.size() - header) / facet;
  const std::size_t at = header + facet * below(engine, facets), corner = at + 12;
  switch (below(engine, 5)) {
    case 0:
      overwrite(changed, header - 4, any_of(engine, counts));
      break;
    case 1:
      overwrite(changed, corner + 4 * below(engine, 9), odd_float(engine));
      break;
    case 2:
      changed.insert(at, changed.substr(at, facet));
      overwrite(changed, header - 4, static_cast<std::uint32_t>(facets + 1));
      break;
    case 3:
      std::swap_ranges(
          changed.begin() + static_cast<std::ptrdiff_t>(corner),
          changed.begin() + static_cast<std::ptrdiff_t>(corner + 12),
          changed.begin() + static_cast<std::ptrdiff_t>(corner + 12)
      );
      break;
    default:
      changed.resize(below(engine, changed.size()));
  }
  return changed;
}

std::string mutated(Reader reader, const Seed& seed, const Seed& donor, Engine& engine) {
  // Often one alone: what is nearly sound goes furthest.
  std::size_t changes = 1;
  if (one_in(engine, 2))
    while (changes < 30 && !one_in(engine, 4)) ++changes;
  std::string bytes = seed.bytes;
  if (seed.tree && !one_in(engine, 10)) {
    Node tree = *seed.tree;
    const Node& other = donor.tree ? *donor.tree : *seed.tree;
    for (std::size_t i = 0; i < changes; ++i) change_tree(tree, other, engine);
    bytes = xml_of(tree, engine);
    changes = one_in(engine, 8) ? 1 : 0;  // of the bytes, besides
  }
  const bool xml = reader == Reader::deck || reader == Reader::card;
  for (std::size_t i = 0; i < changes; ++i)
    bytes = xml ? changed_bytes(bytes, engine) : changed_once(reader, bytes, engine);
  if (bytes.size() > largest) bytes.resize(largest);
  return bytes;
}

}  // namespace barreno::fuzz
