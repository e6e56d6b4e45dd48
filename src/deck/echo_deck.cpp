// SPDX-License-Identifier: BSD-3-Clause
#include "deck/echo_deck.hpp"

#include "base/utf8.hpp"

#include <Teuchos_TwoDArray.hpp>

#include <barreno/input/scan_xml.hpp>
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace barreno {
namespace {

using Teuchos::getValue;

std::string text_of(double x) {
  return input::exact_text(x);
}
const std::string& text_of(const std::string& x) {
  return x;
}

template <class Range>
std::string array_text(const Range& values) {
  std::string text = "{";
  for (const auto& value : values) text += (text.size() > 1 ? ", " : "") + text_of(value);
  return text + "}";
}

std::string type_of(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>()) return "double";
  if (entry.isType<int>()) return "int";
  if (entry.isType<bool>()) return "bool";
  if (entry.isType<std::string>()) return "string";
  if (entry.isType<Teuchos::Array<double>>()) return "Array(double)";
  if (entry.isType<Teuchos::Array<std::string>>()) return "Array(string)";
  if (entry.isType<Teuchos::TwoDArray<double>>()) return "TwoDArray(double)";
  throw std::logic_error("a deck value of a type that no table has");
}

/// A character reference for what an attribute may not hold as it is: marks of XML, line ends and
/// tabs (which readers turn into blanks), and bytes that are not UTF-8, as the characters of
/// Latin-1.
std::string reference(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return "&#" + std::to_string(static_cast<unsigned char>(c)) + ";";
  }
}

std::string escaped(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = character_bytes(text, at);
    const bool plain = bytes > 0 && std::string("&<>\"\t\n\r").find(text[at]) == std::string::npos;
    result += plain ? text.substr(at, bytes) : reference(text[at]);
    at += plain ? bytes : 1;
  }
  return result;
}

/// On one line and without "--", which would end a comment, or make it no comment at all.
std::string comment_of(const std::string& text) {
  std::string result;
  for (const char c : escaped(input::on_one_line(text))) {
    if (c == '-' && !result.empty() && result.back() == '-') result += ' ';
    result += c;
  }
  return result;
}

void write_list(const Teuchos::ParameterList& list, int depth, std::ostream& xml) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  for (auto item = list.begin(); item != list.end(); ++item) {
    const std::string name = escaped(list.name(item));
    const auto& entry = list.entry(item);
    if (entry.isList()) {
      xml << indent << "<ParameterList name=\"" << name << "\">\n";
      write_list(getValue<Teuchos::ParameterList>(entry), depth + 1, xml);
      xml << indent << "</ParameterList>\n";
    } else {
      xml << indent << "<Parameter name=\"" << name << "\" type=\"" << type_of(entry)
          << "\" value=\"" << escaped(value_text(entry)) << "\"/>\n";
    }
  }
}

}  // namespace

std::string value_text(const Teuchos::ParameterEntry& entry) {
  const std::string type = type_of(entry);
  if (type == "double") return text_of(getValue<double>(entry));
  if (type == "int") return std::to_string(getValue<int>(entry));
  if (type == "bool") return getValue<bool>(entry) ? "true" : "false";
  if (type == "string") return getValue<std::string>(entry);
  if (type == "Array(double)") return array_text(getValue<Teuchos::Array<double>>(entry));
  if (type == "Array(string)") return array_text(getValue<Teuchos::Array<std::string>>(entry));
  const auto& table = getValue<Teuchos::TwoDArray<double>>(entry);
  return std::to_string(table.getNumRows()) + "x" + std::to_string(table.getNumCols()) + ":" +
         array_text(table.getDataArray());
}

std::string effective_deck_xml(const Deck& deck) {
  std::ostringstream xml;
  xml << "<!-- Effective deck of " << comment_of(deck.name())
      << ": every value that was used, in SI. -->\n"
      << "<ParameterList name=\"Barreno\">\n";
  write_list(deck.values(), 1, xml);
  xml << "</ParameterList>\n";
  return xml.str();
}

}  // namespace barreno
