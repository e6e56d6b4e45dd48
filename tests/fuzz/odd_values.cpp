// SPDX-License-Identifier: BSD-3-Clause
#include "odd_values.hpp"

#include "deck/deck_schema.hpp"

#include <barreno/models.hpp>
#include <barreno/registry.hpp>

namespace barreno::fuzz {
namespace {

using Strings = std::vector<std::string>;

/// A value that an entry may have, as far as its table tells.
Strings values_of(const input::Entry& entry) {
  if (!entry.words.empty()) {
    Strings values;
    for (const std::string& word : entry.words)
      values.push_back(entry.kind == input::Kind::words ? "{" + word + "}" : word);
    return values;
  }
  switch (entry.kind) {
    case input::Kind::flag:
      return {"true"};
    case input::Kind::vector:
      return {"{0.1, 0.2}", "{0, 0}", "{0.1, 0.1, 0.1}"};
    case input::Kind::table:
      return {"2x2:{0, 1, 1, 2}", "3x2:{0, 0, 0.1, 0, 0, 0.1}"};
    case input::Kind::words:
      return {"{A, B}"};
    default:
      return {entry.default_text.empty() ? "0.1" : entry.default_text, "1"};
  }
}

void collect(const input::Section& section, std::vector<Known>& known) {
  for (const input::Entry& entry : section.entries)
    for (const std::string& value : values_of(entry)) known.push_back({entry.name, value});
  for (const input::Section& part : section.sections) collect(part, known);
  for (const input::Section& part : section.named) collect(part, known);
}

const Strings& odd_texts() {
  static const Strings values = {
      "",
      " ",
      "{",
      "}",
      "{}",
      "{1}",
      "{1, 2, 3, 4}",
      "{nan, 1}",
      "{,}",
      "{1,}",
      "1x2:{1, 2}",
      "0x0:{}",
      "2x5:{1, 2}",
      "1x5:{0, 1e3, 1e-3, 1e-2, 1e4}",
      "-1x-1:{}",
      "1000000000x2:{1}",
      "true",
      "false",
      "TRUE",
      "SI",
      "mm-us-g",
      "mm-mm-mm",
      "a_pipe",
      "a_device",
      "a_folder",
      "a_gigabyte",
      "deck.xml",
      "nothing",
      "../../../etc/passwd",
      "/dev/full",
      "cube.stl",
      "short.stl",
      "holed.stl",
      "good.csv",
      "soft_rubber.card",
      "berea_sandstone.xml",
      "steel_4340.xml",
      "\xff\xfe",
      "\xc3\xa9",
      "a\nb",
      "a\tb",
      "\"",
      "'",
      "<",
      "&",
      "]]>",
      "--",
      "%s%n%d",
      "\x1b[31m",
      "a/b",
      "/",
      "//",
      "*"};
  return values;
}

std::string scaled(const std::string& number, Engine& engine) {
  static const Strings factors = {"e1", "e-1", "e3", "e-3", "e9", "e-9", "e300", "e-300"};
  return number + any_of(engine, factors);
}

}  // namespace

const std::vector<Known>& known_parameters() {
  static const std::vector<Known> all = [] {
    std::vector<Known> known;
    collect(deck_schema(), known);
    for (const ModelDescription& model : describe_models()) {
      known.push_back({"Model", model.name});
      collect(material_section(model), known);
    }
    return known;
  }();
  return all;
}

std::string odd_number(Engine& engine) {
  static const Strings numbers = {
      "0",        "-0",          "1",           "-1",         "2",
      "3",        "7",           "1e-3",        "1e-6",       "1e-9",
      "1e-12",    "1e-15",       "1e3",         "1e6",        "1e9",
      "1e15",     "1e18",        "1e100",       "-1e100",     "1e155",
      "1e308",    "-1e308",      "1.8e308",     "1e309",      "1e-308",
      "4.9e-324", "1e-400",      "nan",         "-nan",       "inf",
      "-inf",     "0x10",        "1,5",         "1.5.2",      "+-1",
      "1e",       ".",           "-",           "2147483647", "2147483648",
      "0.5",      "-2147483649", "4294967296",  "1e10 mm",    "0.3333",
      "1e4",      "1e5",         "0.999999999", "20 mm",      "-5 us",
      "3 GPa",    "1 (((m)))",   "1 m^99",      "1 m/0",      "9223372036854775808"};
  return any_of(engine, numbers);
}

std::string odd_value(Engine& engine) {
  if (one_in(engine, 3)) return odd_number(engine);
  if (one_in(engine, 3)) return any_of(engine, known_parameters()).value;
  if (one_in(engine, 20)) {
    std::string many(200 + below(engine, 5000), 'x');
    return many;
  }
  if (one_in(engine, 20)) return "1 " + std::string(1 + below(engine, 3000), '(');
  if (one_in(engine, 20)) {
    std::string list = "{";
    for (std::size_t i = below(engine, 500); i > 0; --i) list += std::to_string(i) + ",";
    return list + "0}";
  }
  return any_of(engine, odd_texts());
}

std::string changed_value(const std::string& value, Engine& engine) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!is_digit(value[i])) continue;
    const std::size_t begin = i;
    while (i < value.size() && is_digit(value[i])) ++i;
    numbers.emplace_back(begin, i - begin);
  }
  if (numbers.empty() || one_in(engine, 5)) return changed_bytes(value, engine);
  const auto [begin, length] = any_of(engine, numbers);
  std::string number = value.substr(begin, length);
  switch (below(engine, 5)) {
    case 0:
      number = odd_number(engine);
      break;
    case 1:
      number = scaled(number, engine);
      break;
    case 2:
      number = "-" + number;
      break;
    case 3:
      number += ", " + number;
      break;
    default:
      number[below(engine, number.size())] = static_cast<char>('0' + below(engine, 10));
  }
  return value.substr(0, begin) + number + value.substr(begin + length);
}

std::string changed_bytes(const std::string& bytes, Engine& engine) {
  static const Strings pieces = {
      "<!--",
      "-->",
      "<![CDATA[",
      "]]>",
      "<?xml version=\"1.0\"?>",
      "<!DOCTYPE a>",
      "&lt;",
      "&#0;",
      "&a;",
      "</ParameterList>",
      "<ParameterList name=\"a\">",
      "/>",
      "<",
      ">",
      "\"",
      "=",
      "{",
      "}",
      ",",
      "\n",
      "\r",
      "\t",
      "#",
      "# units: mm-us-g\n",
      "solid",
      "facet",
      "endsolid",
      "nan",
      "1e999"};
  std::string changed = bytes;
  const std::size_t at = below(engine, changed.size() + 1);
  const std::size_t left = changed.size() - at;
  const std::size_t length = std::min(left, 1 + below(engine, one_in(engine, 3) ? 500 : 8));
  switch (below(engine, 5)) {
    case 0:
      if (left > 0) changed[at] = static_cast<char>(changed[at] ^ (1 << below(engine, 8)));
      break;
    case 1:
      changed.erase(at, length);
      break;
    case 2:
      changed.insert(at, changed.substr(at, length));
      break;
    case 3:
      if (left > 0) changed[at] = static_cast<char>(below(engine, 256));
      break;
    default:
      changed.insert(at, any_of(engine, pieces));
  }
  return changed;
}

}  // namespace barreno::fuzz
