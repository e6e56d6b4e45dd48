// SPDX-License-Identifier: BSD-3-Clause
#include "scene/load_tables.hpp"

#include <algorithm>
#include <functional>

namespace barreno {
namespace {

Table read_table(
    const Deck& deck, const std::string& path, const std::string& times, const std::string& values
) {
  Table table{deck.vector(path + "/" + times), deck.vector(path + "/" + values)};
  if (table.time.empty() || table.time.size() != table.value.size()) {
    deck.refuse_value(
        path + "/" + values,
        "has " + std::to_string(table.value.size()) + " entries, but " + times + " has " +
            std::to_string(table.time.size()) + " (one belongs to each); make them equal"
    );
  }
  const auto later =
      std::adjacent_find(table.time.begin(), table.time.end(), std::greater_equal<>());
  if (later != table.time.end()) {
    deck.refuse_value(
        path + "/" + times,
        "does not increase at component " + std::to_string(later - table.time.begin() + 2) +
            " (the value there would be ambiguous); sort the times"
    );
  }
  return table;
}

}  // namespace

bool has_pressure(const Deck& deck, const std::string& path) {
  return deck.has(path + "/Pressure") || deck.has(path + "/Times") || deck.has(path + "/Pressures");
}

Table read_pressure(const Deck& deck, const std::string& path) {
  const bool constant = deck.has(path + "/Pressure");
  const bool times = deck.has(path + "/Times"), pressures = deck.has(path + "/Pressures");
  if (constant == (times && pressures) || times != pressures) {
    deck.refuse(
        path,
        "needs either Pressure or both Times and Pressures (one of them says how hard); give one"
    );
  }
  if (constant) return {{0.0}, {deck.number(path + "/Pressure")}};
  return read_table(deck, path, "Times", "Pressures");
}

Table read_factors(const Deck& deck, const std::string& path, const std::string& of) {
  const std::string times = of + "Times", factors = of + "Factors";
  const bool timed = deck.has(path + "/" + times), scaled = deck.has(path + "/" + factors);
  if (!timed && !scaled) return {{0.0}, {1.0}};
  if (timed != scaled)
    deck.refuse_value(
        path + "/" + (timed ? times : factors),
        "stands without " + (timed ? factors : times) +
            " (they are the two columns of a table); give both"
    );
  return read_table(deck, path, times, factors);
}

}  // namespace barreno
