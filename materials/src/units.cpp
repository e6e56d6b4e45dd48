// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/units.hpp"

#include "barreno/input/error.hpp"
#include "text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace barreno::input {
namespace {

struct NamedUnit {
  const char* name;
  Unit unit;
};

/// Units that take no prefix. Inch, pound and pound-force are exact by definition; psi follows from
/// them.
const std::vector<NamedUnit>& plain_units() {
  static const std::vector<NamedUnit> units = {
      {"1", {}},
      {"in", {2.54, -2, dimension::length}},
      {"inch", {2.54, -2, dimension::length}},
      {"ft", {3.048, -1, dimension::length}},
      {"min", {6.0, 1, dimension::time}},
      {"h", {3.6, 3, dimension::time}},
      {"t", {1.0, 3, dimension::mass}},
      {"lb", {4.5359237, -1, dimension::mass}},
      {"K", {1.0, 0, dimension::temperature}},
      {"degC", {1.0, 0, dimension::temperature, 273.15}},
      {"lbf", {4.4482216152605, 0, {1, -2, 1, 0}}},
      {"dyn", {1.0, -5, {1, -2, 1, 0}}},
      {"psi", {6.894757293168361, 3, dimension::stress}},
      {"ksi", {6.894757293168361, 6, dimension::stress}},
      {"atm", {1.01325, 5, dimension::stress}},
      {"erg", {1.0, -7, {2, -2, 1, 0}}},
  };
  return units;
}

const std::vector<NamedUnit>& prefixed_units() {
  static const std::vector<NamedUnit> units = {
      {"m", {1.0, 0, dimension::length}},
      {"s", {1.0, 0, dimension::time}},
      {"g", {1.0, -3, dimension::mass}},
      {"Pa", {1.0, 0, dimension::stress}},
      {"bar", {1.0, 5, dimension::stress}},
      {"N", {1.0, 0, {1, -2, 1, 0}}},
      {"J", {1.0, 0, {2, -2, 1, 0}}},
      {"W", {1.0, 0, {2, -3, 1, 0}}},
      {"Hz", {1.0, 0, dimension::rate}},
      {"D", {9.869232667160130, -13, dimension::area}},  // darcy: 1 cP cm2/s per atm/cm
      {"P", {1.0, -1, dimension::viscosity}},            // poise
  };
  return units;
}

/// The last two are the two code points of the micro sign.
constexpr std::array<std::pair<std::string_view, int>, 10> prefixes = {
    {{"n", -9},
     {"u", -6},
     {"m", -3},
     {"c", -2},
     {"k", 3},
     {"M", 6},
     {"G", 9},
     {"T", 12},
     {"\xc2\xb5", -6},
     {"\xce\xbc", -6}}};

std::optional<Unit> find_unit(std::string_view name) {
  for (const auto& [plain, unit] : plain_units()) {
    if (name == plain) return unit;
  }
  for (const auto& [base, unit] : prefixed_units()) {
    if (name == base) return unit;
    for (const auto& [prefix, exponent] : prefixes) {
      if (name == std::string(prefix) + base) {
        Unit scaled = unit;
        scaled.exponent += exponent;
        return scaled;
      }
    }
  }
  return std::nullopt;
}

Unit power(const Unit& unit, int n) {
  const Dimension& d = unit.dimension;
  return {
      std::pow(unit.mantissa, n),
      unit.exponent * n,
      {d.length * n, d.time * n, d.mass * n, d.temperature * n}};
}

Unit product(const Unit& a, const Unit& b) {
  const Dimension &p = a.dimension, &q = b.dimension;
  return {
      a.mantissa * b.mantissa,
      a.exponent + b.exponent,
      {p.length + q.length, p.time + q.time, p.mass + q.mass, p.temperature + q.temperature}};
}

/// Recursive descent over: expression = factor { [* / . blank] factor }, factor = name [power] | (
/// expression ).
class UnitReader {
public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  Unit read() {
    const Unit unit = expression();
    if (at_ < text_.size()) refuse();
    return unit;
  }

private:
  [[noreturn]] void refuse() const {
    throw InputError(
        "has an unknown unit '" + cut_end(text_, 60) +
        "' (units are products, quotients and powers of m, s, g, K, Pa, N, J and the like, with "
        "prefixes); "
        "write for example \"12.7 mm\", \"10 ksi\" or \"2.3 g/cm3\""
    );
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool at_end() {
    skip_blanks();
    return at_ >= text_.size() || text_[at_] == ')';
  }

  Unit expression() {
    Unit unit = factor();
    while (!at_end()) {
      const char c = text_[at_];
      if (c == '*' || c == '/' || c == '.') ++at_;
      const Unit next = factor();
      unit = sound(product(unit, c == '/' ? power(next, -1) : next));
    }
    return unit;
  }

  Unit factor() {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '(') {
      if (++depth_ > deepest) refuse();
      ++at_;
      const Unit unit = expression();
      --depth_;
      if (at_ >= text_.size() || text_[at_] != ')') refuse();
      ++at_;
      return raise(unit);
    }
    const std::size_t begin = at_;
    if (at_ < text_.size() && text_[at_] == '1') {
      ++at_;
    } else {
      while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    }
    const auto unit = find_unit(text_.substr(begin, at_ - begin));
    if (!unit) refuse();
    return raise(*unit);
  }

  Unit raise(const Unit& unit) {
    std::size_t at = at_;
    if (at < text_.size() && text_[at] == '^') ++at;
    int n = 0;
    const auto [end, error] = std::from_chars(text_.data() + at, text_.data() + text_.size(), n);
    if (error != std::errc{}) {
      if (at != at_) refuse();
      return unit;
    }
    // Larger exponents do not occur in physics and would overflow the decimal exponent.
    if (std::abs(n) > 12) refuse();
    at_ = static_cast<std::size_t>(end - text_.data());
    return sound(power(unit, n));
  }

  /// Powers of powers and very long products would overflow.
  Unit sound(const Unit& unit) const {
    constexpr int most = 1000;
    const Dimension& d = unit.dimension;
    for (const int n : {unit.exponent, d.length, d.time, d.mass, d.temperature})
      if (std::abs(n) > most) refuse();
    return unit;
  }

  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           static_cast<unsigned char>(c) >= 0x80;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  static constexpr int deepest = 8;  ///< brackets in brackets
  int depth_ = 0;
};

bool is_unit(std::string_view text) {
  try {
    UnitReader(text).read();
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

double to_si(double value, const Unit& unit) {
  double si = value * unit.mantissa;
  // Powers of ten up to 1e22 are exact doubles, so one multiplication or division rounds once.
  const double scale = std::pow(10.0, std::abs(unit.exponent));
  si = unit.exponent < 0 ? si / scale : si * scale;
  return si + unit.zero;
}

Unit UnitSystem::unit_of(const Dimension& d) const {
  Unit unit = product(product(power(length, d.length), power(time, d.time)), power(mass, d.mass));
  unit.dimension = d;
  return unit;
}

UnitSystem read_unit_system(const std::string& name) {
  UnitSystem units;
  units.name = name;
  if (name == "SI") return units;
  Dimension found{};
  for (const std::string& word : split(name, '-')) {
    const auto unit = find_unit(word);
    if (unit && unit->dimension == dimension::length) units.length = *unit, ++found.length;
    if (unit && unit->dimension == dimension::time) units.time = *unit, ++found.time;
    if (unit && unit->dimension == dimension::mass) units.mass = *unit, ++found.mass;
    if (!unit) found.temperature = 1;
  }
  if (!(found == Dimension{1, 1, 1, 0})) {
    throw InputError(
        "names no consistent system of units (one unit of length, one of time and one of mass are "
        "expected); write \"SI\", \"mm-us-g\", \"cm-us-g\" or \"mm-ms-kg\""
    );
  }
  return units;
}

Unit read_unit(std::string_view text) {
  return UnitReader(text).read();
}

double read_quantity(std::string_view text, const Dimension& dimension, const UnitSystem& units) {
  text = trim(text);
  const std::string write = "write for example \"" + example_of(dimension) + "\"";
  double value = 0.0;
  // from_chars knows no leading '+', and would accept the words inf and nan.
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const bool looks_like_number = !digits.empty() && (digits.find_first_of("0123456789") <= 2) &&
                                 digits.find_first_of("in") != 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    throw InputError("is beyond the range of a double (about 1e-308 to 1e308); " + write);
  }
  if (!looks_like_number || error != std::errc{}) {
    throw InputError("is not a number (" + words_of(dimension) + " is expected here); " + write);
  }
  const std::string_view suffix =
      trim(digits.substr(static_cast<std::size_t>(end - digits.data())));
  if (!suffix.empty() && suffix.front() == ',') {
    throw InputError("is not a number (the decimal separator is a point, not a comma); " + write);
  }
  const bool known = suffix.empty() || is_unit(suffix);
  if (!known && dimension == dimension::none) {
    throw InputError("is not a number (" + words_of(dimension) + " is expected here); " + write);
  }
  const Unit unit = suffix.empty() ? units.unit_of(dimension) : read_unit(suffix);
  if (!(unit.dimension == dimension)) {
    throw InputError(
        "has the unit of " + words_of(unit.dimension) + " ('" + cut_end(suffix, 60) + "'), but " +
        words_of(dimension) + " is expected here; " + write
    );
  }
  const double si = to_si(value, unit);
  if (!std::isfinite(si)) {
    throw InputError("is beyond the range of a double in SI (about 1e308); " + write);
  }
  return si;
}

}  // namespace barreno::input
