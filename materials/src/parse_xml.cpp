// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/error.hpp"
#include "barreno/input/scan_xml.hpp"
#include "text.hpp"

#include <Teuchos_StringInputSource.hpp>

#include <algorithm>
#include <cctype>
#include <optional>

namespace barreno::input {
namespace {

/// Where the markup that begins at `at` ends; values in quotes may hold a '>'.
std::size_t end_of_markup(const std::string& text, std::size_t at) {
  if (text.compare(at, 4, "<!--") == 0) return text.find("-->", at + 4);
  if (text.compare(at, 2, "<?") == 0) return text.find("?>", at + 2);
  char quote = '\0';
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i;
    }
  }
  return std::string::npos;
}

/// Nesting depth of the tags of a text that need not be well-formed; comments do not count. Every
/// character is looked at once.
int nesting_of(const std::string& text) {
  int depth = 0, deepest = 0;
  std::size_t at = text.find('<');
  while (at != std::string::npos) {
    const std::size_t end = end_of_markup(text, at);
    if (end == std::string::npos) return deepest;
    const char next = text[at + 1];
    if (next == '/') depth = std::max(0, depth - 1);
    if (next != '/' && next != '?' && next != '!' && text[end - 1] != '/') ++depth;
    deepest = std::max(deepest, depth);
    at = text.find('<', end);
  }
  return deepest;
}

bool contains_word(const std::string& text, const std::string& word) {
  const auto same = [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

/// The first control character of the texts of a tree, which XML does not allow even as a
/// reference such as &#27;, and which would end a text, or move a terminal's cursor; -1 if none.
int control_character_of(const Teuchos::XMLObject& xml) {
  for (const char* name : {"name", "type", "value"}) {
    if (!xml.hasAttribute(name)) continue;
    if (const int found = control_character(xml.getAttribute(name)); found >= 0) return found;
  }
  for (int i = 0; i < xml.numChildren(); ++i)
    if (const int found = control_character_of(xml.getChild(i)); found >= 0) return found;
  return -1;
}

/// The first name of a tree that holds a line end or a tab. Names are printed in tables, logs and
/// notes, where a line end would begin a line of its own.
std::optional<std::string> name_of_lines(const Teuchos::XMLObject& xml) {
  if (xml.hasAttribute("name")) {
    const std::string& name = xml.getAttribute("name");
    if (on_one_line(name) != name) return name;
  }
  for (int i = 0; i < xml.numChildren(); ++i)
    if (auto found = name_of_lines(xml.getChild(i))) return found;
  return std::nullopt;
}

/// Teuchos' message carries the throw's location and number around the part that a user can act on.
std::string reason_of(const std::string& message) {
  const std::string begin = "XML parse error at ", filler = "document not well-formed: ";
  const std::size_t found = message.find(begin);
  if (found == std::string::npos) return "(it has no root element)";
  std::string reason = message.substr(found + begin.size());
  reason = reason.substr(0, reason.find('\n'));
  const std::size_t colon = reason.find(": ");
  if (colon == std::string::npos) return "at " + reason;
  const std::string place = reason.substr(0, colon);
  reason.erase(0, colon + 2);
  if (reason.compare(0, filler.size(), filler) == 0) reason.erase(0, filler.size());
  return "at " + place + " (" + cut_middle(reason, 200) + ")";
}

/// Refuses what Teuchos is not to read.
void check_text(const std::string& text, const std::string& source) {
  if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
    refuse(source, "", "is text in UTF-16 (decks and cards are in UTF-8); save it as UTF-8");
  if (text.size() > largest_text) {
    refuse(
        source,
        "",
        "has " + std::to_string(text.size()) + " bytes (a deck or card has at most " +
            std::to_string(largest_text) + "); is it the right file?"
    );
  }
  if (text.find('\0') != std::string::npos)
    refuse(source, "", "is not text (it holds a zero byte); is it the right file?");
  if (contains_word(text, "<!DOCTYPE") || contains_word(text, "<!ENTITY")) {
    refuse(
        source,
        "",
        "declares a document type or an entity (these are not read); remove the declaration"
    );
  }
  if (nesting_of(text) > deepest_nesting) {
    refuse(
        source,
        "",
        "nests lists deeper than " + std::to_string(deepest_nesting) +
            " levels (no section needs that); is a closing tag missing?"
    );
  }
}

/// Refuses what XML and decks do not have.
void check_tree(const Teuchos::XMLObject& root, const std::string& source) {
  if (const int code = control_character_of(root); code >= 0) {
    refuse(
        source,
        "",
        "holds the control character " + std::to_string(code) +
            " in a name or a value (XML has none but tab and line end); is it the right file?"
    );
  }
  if (const auto name = name_of_lines(root)) {
    refuse(
        source,
        "",
        "has the name " + shown(*name) +
            ", which holds a line end or a tab (a name is one line of text); write it with blanks"
    );
  }
  if (root.getTag() != "ParameterList") {
    refuse(
        source,
        "",
        "has the root element '" + root.getTag() +
            "' (a Teuchos ParameterList is expected); write <ParameterList name=\"...\">"
    );
  }
}

}  // namespace

Teuchos::XMLObject parse_xml(const std::string& text, const std::string& source) {
  // Editors put a byte-order mark in front, which XML allows and Teuchos does not know.
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) return parse_xml(text.substr(3), source);
  check_text(text, source);
  Teuchos::XMLObject root;
  try {
    root = Teuchos::StringInputSource(text).getObject();
  } catch (const std::exception& error) {
    refuse(
        source, "", "is not well-formed XML " + reason_of(error.what()) + "; correct the file there"
    );
  }
  check_tree(root, source);
  return root;
}

}  // namespace barreno::input
