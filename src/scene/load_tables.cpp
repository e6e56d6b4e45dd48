// SPDX-License-Identifier: BSD-3-Clause
#include "scene/load_tables.hpp"

namespace barreno {
namespace {

Table read_table(const Deck& deck, const std::string& path, const std::string& values) {
  Table table{deck.vector(path + "/Times"), deck.vector(path + "/" + values)};
  if (table.time.empty() || table.time.size() != table.value.size()) {
    deck.refuse_value(
        path + "/" + values,
        "has " + std::to_string(table.value.size()) + " entries, but Times has " +
            std::to_string(table.time.size()) + " (one belongs to each); make them equal"
    );
  }
  for (std::size_t i = 1; i < table.time.size(); ++i) {
    if (!(table.time[i] > table.time[i - 1])) {
      deck.refuse_value(
          path + "/Times",
          "does not increase at component " + std::to_string(i + 1) +
              " (the value there would be ambiguous); sort the times"
      );
    }
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
  return read_table(deck, path, "Pressures");
}

Table read_factors(const Deck& deck, const std::string& path, bool moves) {
  const bool times = deck.has(path + "/Times"), factors = deck.has(path + "/Factors");
  if (!times && !factors) return {{0.0}, {1.0}};
  const std::string given = path + (times ? "/Times" : "/Factors");
  if (!moves)
    deck.refuse_value(
        given, "has no meaning for this Kind; remove it or write prescribed velocity"
    );
  if (times != factors)
    deck.refuse_value(
        given,
        std::string("stands without ") + (times ? "Factors" : "Times") +
            " (they are the two columns of a table); give both"
    );
  return read_table(deck, path, "Factors");
}

}  // namespace barreno
