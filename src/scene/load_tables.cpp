// SPDX-License-Identifier: BSD-3-Clause
#include "scene/load_tables.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <functional>

namespace barreno {
namespace {

Table read_table(
    const Deck& deck, const std::string& path, const std::string& times, const std::string& values
) {
  Table table{deck.vector(input::join(path, times)), deck.vector(input::join(path, values))};
  if (table.time.empty() || table.time.size() != table.value.size()) {
    deck.refuse_value(
        input::join(path, values),
        "has " + std::to_string(table.value.size()) + " entries, but " + times + " has " +
            std::to_string(table.time.size()) + " (each needs one); make the lengths equal"
    );
  }
  const auto later =
      std::adjacent_find(table.time.begin(), table.time.end(), std::greater_equal<>());
  if (later != table.time.end()) {
    deck.refuse_value(
        input::join(path, times),
        "does not increase at component " + std::to_string(later - table.time.begin() + 2) +
            " (the value there would be ambiguous); sort the times"
    );
  }
  return table;
}

}  // namespace

bool has_pressure(const Deck& deck, const std::string& path) {
  return deck.has(input::join(path, pressure_word)) || deck.has(input::join(path, times_word)) ||
         deck.has(input::join(path, pressures_word));
}

Table read_pressure(const Deck& deck, const std::string& path) {
  const std::string pressure = input::join(path, pressure_word);
  const bool constant = deck.has(pressure);
  const bool times = deck.has(input::join(path, times_word));
  const bool pressures = deck.has(input::join(path, pressures_word));
  if (constant == (times && pressures) || times != pressures) {
    deck.refuse(
        path,
        "needs either Pressure or both Times and Pressures (one of them must give the magnitude); "
        "give one"
    );
  }
  if (constant) return {{0.0}, {deck.number(pressure)}};
  return read_table(deck, path, times_word, pressures_word);
}

Table read_factors(const Deck& deck, const std::string& path, const std::string& of) {
  const std::string times = of + times_word, factors = of + factors_word;
  const bool timed = deck.has(input::join(path, times));
  const bool scaled = deck.has(input::join(path, factors));
  if (!timed && !scaled) return {{0.0}, {1.0}};
  if (timed != scaled)
    deck.refuse_value(
        input::join(path, timed ? times : factors),
        "is given without " + (timed ? factors : times) +
            " (they are the two columns of a table); give both"
    );
  return read_table(deck, path, times, factors);
}

}  // namespace barreno
