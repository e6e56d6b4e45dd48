// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"

#include <cstdio>
#include <string>

namespace barreno::arenisca {

// A part of the law owns everything about itself: its Parameters with name, unit, bounds and
// meaning (parameter_table), the rules between them (check: a sentence that names the parameter, or
// nothing), and its evaluation over R, one point or several (real.hpp). A form of the law is a list
// of parts (list.hpp); its parameters and its table are joined from theirs. Rules between parts
// stand in ../../models/arenisca_rules.hpp.

/// "PEAKI1 = 2.1e+07": a parameter and its value, as messages name it.
inline std::string named(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s = %.6g", name, value);
  return text;
}
/// The value alone.
inline std::string shown(double value) {
  return named("", value).substr(3);
}

/// Appends the table of a part to that of a whole, which inherits the part's parameters.
template <class Whole, class Part>
void add_table(const ParameterTable<Part>& part, ParameterTable<Whole>& whole) {
  for (const auto& n : part.numbers)
    whole.numbers.push_back(
        {n.member, n.name, n.dimension, n.bounds, n.meaning, n.required, n.default_value}
    );
  for (const auto& c : part.choices)
    whole.choices.push_back({c.member, c.name, c.words, c.default_index, c.meaning});
}

}  // namespace barreno::arenisca
