// SPDX-License-Identifier: BSD-3-Clause
#include "deck/describe_entry.hpp"

#include "deck/describe_deck.hpp"

#include <barreno/input/units.hpp>
#include <barreno/plausible.hpp>
#include <cmath>
#include <cstdio>

namespace barreno {
namespace {

using input::Entry;
using input::Kind;
using input::Presence;

std::string number_text(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%g", x);
  return buffer;
}

std::string columns_text(const Entry& entry) {
  std::vector<std::string> units;
  for (const Dimension& column : entry.columns) {
    const std::string unit = input::si_unit_of(column);
    units.push_back(unit.empty() ? "-" : unit);
  }
  return "table of [" + with_commas(units) + "]";
}

std::string bounds_text(const Bounds& b) {
  std::string text;
  if (std::isfinite(b.lower)) text = (b.lower_open ? "> " : ">= ") + number_text(b.lower);
  if (std::isfinite(b.upper)) {
    text += (text.empty() ? "" : ", ") + std::string(b.upper_open ? "< " : "<= ") +
            number_text(b.upper);
  }
  return text;
}

/// The usual range of a parameter of a model, in SI; empty where none is known.
std::string usual_text(const std::string& model, const std::string& parameter) {
  const PlausibleRange* const range = find_plausible_range(model, parameter);
  if (range == nullptr) return {};
  return std::string(range->of_magnitude ? "usual magnitude " : "usual ") +
         number_text(range->lower) + " to " + number_text(range->upper);
}

}  // namespace

std::string type_text(const Entry& entry) {
  const std::string unit = input::si_unit_of(entry.dimension);
  const std::string suffix = unit.empty() ? "" : " [" + unit + "]";
  switch (entry.kind) {
    case Kind::number:
      return "number" + suffix + (entry.words.empty() ? "" : " or: " + with_commas(entry.words));
    case Kind::integer:
      return "integer";
    case Kind::text:
      return "text";
    case Kind::file:
      return "file";
    case Kind::flag:
      return "true or false";
    case Kind::word:
      return "one of: " + with_commas(entry.words);
    case Kind::words:
      return entry.words.empty() ? "array of names" : "array of: " + with_commas(entry.words);
    case Kind::vector:
      return "array" + suffix;
    case Kind::table:
      return columns_text(entry);
  }
  return {};
}

std::string limits_text(const Entry& entry, const std::string& model) {
  const std::string bounds = bounds_text(entry.bounds), usual = usual_text(model, entry.name);
  return bounds + (bounds.empty() || usual.empty() ? "" : "; ") + usual;
}

std::string default_text(const Entry& entry) {
  if (entry.presence == Presence::required) return "required";
  if (entry.presence == Presence::optional) return "optional";
  return entry.default_text.empty() ? "default: empty" : "default: " + entry.default_text;
}

void write_entry(const Entry& entry, std::ostream& out, const std::string& model) {
  const std::string bounds = limits_text(entry, model);
  out << "  " << entry.name << "\n      " << entry.meaning << "\n      " << type_text(entry)
      << (bounds.empty() ? "" : ", " + bounds) << "; " << default_text(entry) << '\n';
}

}  // namespace barreno
