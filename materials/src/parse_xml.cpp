// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/error.hpp"
#include "barreno/input/scan_xml.hpp"

#include <Teuchos_StringInputSource.hpp>

#include <algorithm>
#include <cctype>
#include <regex>

namespace barreno::input {
namespace {

/// Nesting depth of the tags of a text that need not be well-formed; comments do not count.
int nesting_of(const std::string& text) {
  int depth = 0, deepest = 0;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      if (at == std::string::npos) return deepest;
      continue;
    }
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return deepest;
    const char next = text[at + 1];
    if (next == '/') --depth;
    if (next != '/' && next != '?' && next != '!' && text[end - 1] != '/') ++depth;
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

bool contains_word(const std::string& text, const std::string& word) {
  const auto same = [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

/// Teuchos' message carries the throw's location and number around the part that a user can act on.
std::string reason_of(const std::string& message) {
  std::smatch match;
  const std::regex pattern("XML parse error at (line [0-9]+): (document not well-formed: )?([^\n]*)"
  );
  if (std::regex_search(message, match, pattern)) {
    return "at " + match.str(1) + " (" + match.str(3) + ")";
  }
  return "(it has no root element)";
}

}  // namespace

Teuchos::XMLObject parse_xml(const std::string& text, const std::string& source) {
  if (text.size() > largest_text) {
    refuse(
        source,
        "",
        "has " + std::to_string(text.size()) + " bytes (a deck or card has at most " +
            std::to_string(largest_text) + "); is it the right file?"
    );
  }
  if (text.find('\0') != std::string::npos) {
    refuse(source, "", "is not text (it holds a zero byte); is it the right file?");
  }
  if (contains_word(text, "<!DOCTYPE") || contains_word(text, "<!ENTITY")) {
    refuse(
        source,
        "",
        "declares a document type or an entity (they are not read); remove the declaration"
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
  Teuchos::XMLObject root;
  try {
    root = Teuchos::StringInputSource(text).getObject();
  } catch (const std::exception& error) {
    refuse(
        source, "", "is not well-formed XML " + reason_of(error.what()) + "; correct the file there"
    );
  }
  if (root.getTag() != "ParameterList") {
    refuse(
        source,
        "",
        "has the root element '" + root.getTag() +
            "' (a Teuchos ParameterList belongs there); write <ParameterList name=\"...\">"
    );
  }
  return root;
}

}  // namespace barreno::input
