// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/error.hpp"
#include "barreno/input/nearest_name.hpp"
#include "barreno/input/scan_xml.hpp"
#include "text.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace barreno::input {
namespace {

std::string format(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.10g", x);
  return buffer;
}

std::string words_of(const Bounds& b, const std::string& unit) {
  const std::string suffix = unit.empty() ? "" : " " + unit;
  const bool below = std::isfinite(b.upper), above = std::isfinite(b.lower);
  const std::string lower = (b.lower_open ? "above " : "at least ") + format(b.lower) + suffix;
  const std::string upper = (b.upper_open ? "below " : "at most ") + format(b.upper) + suffix;
  if (above && below) return lower + " and " + upper;
  return above ? lower : upper;
}

double number_of(
    std::string_view text, const Entry& entry, const Dimension& d, const UnitSystem& units
) {
  const double value = read_quantity(text, d, units);
  if (!entry.bounds.contain(value)) {
    throw InputError(
        "is out of bounds (it must be " + words_of(entry.bounds, si_unit_of(d)) +
        "); choose a value in that range"
    );
  }
  return value;
}

/// A number, or one of the words that may stand in its place.
void put_number(
    Teuchos::ParameterList& list,
    const Entry& entry,
    const std::string& text,
    const UnitSystem& units
) {
  const std::string word(trim(text));
  if (std::find(entry.words.begin(), entry.words.end(), word) != entry.words.end()) {
    list.set(entry.name, word, entry.meaning);
    return;
  }
  try {
    list.set(entry.name, number_of(text, entry, entry.dimension, units), entry.meaning);
  } catch (const InputError& error) {
    if (entry.words.empty() || word.find_first_of("0123456789") != std::string::npos) throw;
    throw InputError(error.what() + (", or \"" + entry.words.front() + "\""));
  }
}

int integer_of(const std::string& text, const Entry& entry) {
  const double value = number_of(text, entry, dimension::none, {});
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
    throw InputError("is not a whole number, or is too large; write for example 4");
  }
  return static_cast<int>(value);
}

std::string word_of(const std::string& text, const Entry& entry) {
  std::string word(trim(text));
  if (std::find(entry.words.begin(), entry.words.end(), word) == entry.words.end()) {
    throw InputError("is not a valid choice; " + suggest_name(word, entry.words));
  }
  return word;
}

bool flag_of(const std::string& text) {
  const std::string_view word = trim(text);
  if (word != "true" && word != "false") {
    throw InputError("is neither true nor false; write one of the two");
  }
  return word == "true";
}

/// The inside of "{...}", split at commas.
std::vector<std::string> parts_of(std::string_view text, const std::string& example) {
  text = trim(text);
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') {
    throw InputError(
        "is not an array (values in braces are expected here); write for example \"" + example +
        "\""
    );
  }
  return split(text.substr(1, text.size() - 2), ',');
}

/// An error inside an array names the component, which the whole array's text does not.
double component_of(
    const std::vector<std::string>& parts,
    std::size_t i,
    const Entry& entry,
    const Dimension& d,
    const UnitSystem& units
) {
  try {
    return number_of(parts[i], entry, d, units);
  } catch (const InputError& error) {
    const std::string where =
        "component " + std::to_string(i + 1) + " of " + std::to_string(parts.size());
    throw InputError("has the wrong " + where + ": " + shown(parts[i]) + " " + error.what());
  }
}

Teuchos::Array<double> vector_of(
    const std::string& text, const Entry& entry, const UnitSystem& units
) {
  const std::string example = example_of(entry.dimension);
  const auto parts = parts_of(text, "{" + example + ", " + example + "}");
  Teuchos::Array<double> values;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    values.push_back(component_of(parts, i, entry, entry.dimension, units));
  }
  return values;
}

Teuchos::TwoDArray<double> table_of(
    const std::string& text, const Entry& entry, const UnitSystem& units
) {
  const std::size_t columns = entry.columns.size();
  const std::string shape = "ROWSx" + std::to_string(columns) + ":{...}";
  const std::size_t colon = text.find(':');
  const auto sizes = split(text.substr(0, colon), 'x');
  if (colon == std::string::npos || sizes.size() != 2) {
    throw InputError(
        "is not a table (rows, columns and values are expected here); write \"" + shape + "\""
    );
  }
  const auto parts = parts_of(text.substr(colon + 1), shape);
  const std::size_t rows = parts.size() / columns;
  if (sizes[1] != std::to_string(columns) || sizes[0] != std::to_string(rows) ||
      parts.size() != rows * columns) {
    throw InputError(
        "holds " + std::to_string(parts.size()) + " values, which does not match its size (" +
        std::to_string(columns) + " columns are needed); write \"" + shape + "\""
    );
  }
  using Index = Teuchos::TwoDArray<double>::size_type;
  Teuchos::TwoDArray<double> values(static_cast<Index>(rows), static_cast<Index>(columns));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    values(static_cast<Index>(i / columns), static_cast<Index>(i % columns)) =
        component_of(parts, i, entry, entry.columns[i % columns], units);
  }
  return values;
}

Teuchos::Array<std::string> words_list_of(const std::string& text, const Entry& entry) {
  Teuchos::Array<std::string> values;
  std::set<std::string> seen;
  const bool any_name = entry.words.empty();
  for (const std::string& part :
       parts_of(text, any_name ? "{A, B}" : "{" + entry.words.front() + "}")) {
    const std::string word = any_name ? part : word_of(part, entry);
    if (!seen.insert(word).second) {
      throw InputError("names '" + word + "' twice; name it once");
    }
    values.push_back(word);
  }
  return values;
}

}  // namespace

void put_value(
    Teuchos::ParameterList& list,
    const Entry& entry,
    const std::string& text,
    const UnitSystem& units
) {
  const std::string& name = entry.name;
  switch (entry.kind) {
    case Kind::number:
      put_number(list, entry, text, units);
      return;
    case Kind::integer:
      list.set(name, integer_of(text, entry), entry.meaning);
      return;
    case Kind::text:
    case Kind::file:
      list.set(name, std::string(trim(text)), entry.meaning);
      return;
    case Kind::word:
      list.set(name, word_of(text, entry), entry.meaning);
      return;
    case Kind::words:
      list.set(name, words_list_of(text, entry), entry.meaning);
      return;
    case Kind::flag:
      list.set(name, flag_of(text), entry.meaning);
      return;
    case Kind::vector:
      list.set(name, vector_of(text, entry, units), entry.meaning);
      return;
    case Kind::table:
      list.set(name, table_of(text, entry, units), entry.meaning);
      return;
  }
}

}  // namespace barreno::input
