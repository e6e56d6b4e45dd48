// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/parts.hpp"

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

}  // namespace barreno::arenisca
