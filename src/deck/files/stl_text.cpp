// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/stl_text.hpp"

#include "base/error.hpp"
#include "deck/files/table_text.hpp"

#include <barreno/input/scan_xml.hpp>
#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

namespace barreno {
namespace {

/// Words of a line, and which of them is next.
struct Line {
  int number = 0;
  std::vector<std::string> words;
  std::size_t at = 0;
};

/// Reads word by word: exporters differ in where they end lines.
class StlWords {
public:
  StlWords(const std::string& text, const std::string& source) : stream_(text), source_(source) {}

  bool at_end() {
    while (line_.at >= line_.words.size()) {
      std::string text;
      if (!std::getline(stream_, text)) return true;
      ++line_.number;
      line_.words.clear();
      line_.at = 0;
      std::istringstream words(text);
      for (std::string word; words >> word;) line_.words.push_back(word);
    }
    return false;
  }

  /// As it stands; a name that follows "solid" ends with the line.
  std::string next() {
    if (at_end())
      throw DeckError(
          source_ + " is not a complete STL file (it ends in line " + std::to_string(line_.number) +
          ", before endsolid); export it again."
      );
    return line_.words[line_.at++];
  }
  void skip_line() { line_.at = line_.words.size(); }

  /// "endloop" of "end loop" too.
  std::string keyword() {
    std::string word = lower_case(next());
    if (word == "end") word += lower_case(next());
    return word;
  }
  void expect(const std::string& wanted) {
    const std::string found = keyword();
    if (found != wanted)
      refuse(found, " where \"" + wanted + "\" is expected; export the file again");
  }

  /// @param problem  what follows the word in the sentence
  [[noreturn]] void refuse(const std::string& word, const std::string& problem) const {
    const std::string line = "line " + std::to_string(line_.number);
    input::refuse(source_, line, "has " + input::shown(word) + problem);
  }

  /// A coordinate, digits as they stand.
  std::string number() {
    std::string word = next();
    const char* const begin = word.c_str() + (word[0] == '+' ? 1 : 0);
    const char* const end = word.c_str() + word.size();
    double value = 0.0;
    const auto [rest, error] = std::from_chars(begin, end, value);
    if (word.find(',') != std::string::npos)
      refuse(word, " (STL files have decimal points, no commas); export it with points");
    if (error == std::errc::invalid_argument || rest != end)
      refuse(word, ", which is not a number (a coordinate is expected); export the file again");
    if (!std::isfinite(value) || error == std::errc::result_out_of_range) {
      if (std::fabs(std::strtod(begin, nullptr)) < 1.0) return "0";  // too small for a double
      refuse(
          word, ", which is not a finite number (a corner needs a place); export the file again"
      );
    }
    return begin;
  }

private:
  std::istringstream stream_;
  const std::string& source_;
  Line line_;
};

void read_facet(StlWords& words, std::string& out) {
  words.expect("normal");
  // Normals follow from the corners; exporters write "nan" for facets without an area.
  for (int i = 0; i < 3; ++i) words.next();
  words.expect("outer");
  words.expect("loop");
  out += "facet normal 0 0 0\nouter loop\n";
  for (int corner = 0; corner < 3; ++corner) {
    words.expect("vertex");
    out += "vertex";
    for (int i = 0; i < 3; ++i) out += " " + words.number();
    out += "\n";
  }
  words.expect("endloop");
  words.expect("endfacet");
  out += "endloop\nendfacet\n";
}

void read_solid(StlWords& words, std::string& out) {
  words.expect("solid");
  words.skip_line();
  out += "solid\n";
  for (;;) {
    const std::string word = words.keyword();
    if (word == "endsolid") break;
    if (word != "facet")
      words.refuse(word, " where \"facet\" or \"endsolid\" is expected; export the file again");
    read_facet(words, out);
  }
  words.skip_line();
  out += "endsolid\n";
}

}  // namespace

bool begins_as_stl_text(const std::string& bytes) {
  std::size_t begin = bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  begin = bytes.find_first_not_of(" \t\r\n", begin);
  return begin != std::string::npos && lower_case(bytes.substr(begin, 5)) == "solid";
}

std::string plain_stl_text(const std::string& bytes, const std::string& source) {
  std::string text = bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? bytes.substr(3) : bytes;
  for (std::size_t i = 0; i < text.size(); ++i)  // "\r" alone ends a line too
    if (text[i] == '\r') text[i] = i + 1 < text.size() && text[i + 1] == '\n' ? ' ' : '\n';
  StlWords words(text, source);
  std::string out;
  out.reserve(text.size());
  do read_solid(words, out);
  while (!words.at_end());
  return out;
}

}  // namespace barreno
