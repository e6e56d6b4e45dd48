// SPDX-License-Identifier: BSD-3-Clause
#include "deck/describe_results.hpp"

#include "deck/search_words.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace barreno {
namespace {

namespace fs = std::filesystem;
constexpr const char* begin_mark = "<!-- words of ";
constexpr const char* end_mark = "<!-- end of words -->";

/// Cells of a row "| a | b |", without the blanks around them.
std::vector<std::string> cells_of_row(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    const auto first = cell.find_first_not_of(' ');
    const auto last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// The words of a cell "`a.b`, `.c`, `_y`"; one that begins with a dot or a line has another end
/// than the first.
std::vector<std::string> words_in_cell(const std::string& cell) {
  std::vector<std::string> words;
  std::istringstream in(cell);
  bool inside = false;
  for (std::string part; std::getline(in, part, '`'); inside = !inside) {
    if (!inside || part.empty()) continue;
    const bool ending = !words.empty() && (part[0] == '.' || part[0] == '_');
    words.push_back(ending ? words[0].substr(0, words[0].rfind(part[0])) + part : part);
  }
  return words;
}

/// Whether a user who asks for a name means a word: all of it, or one of the names in it that dots
/// part.
bool word_means(const std::string& asked, const std::string& word) {
  const auto stands_in = [&](const std::string& text) {
    return ("." + text + ".").find("." + asked + ".") != std::string::npos;
  };
  const bool small = asked == in_small_letters(asked);
  return !asked.empty() && (stands_in(word) || (small && stands_in(in_small_letters(word))));
}

/// Text of a page for the screen: links as their words, no marks of code.
std::string without_marks(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ']' && text.compare(i, 2, "](") == 0)
      i = std::min(text.find(')', i), text.size());
    else if (text[i] != '`' && text[i] != '[')
      out += text[i];
  }
  return out;
}

/// The words of a row that are meant, and what they mean.
void describe_row(
    const std::string& row, const std::string& file, const std::string& name, std::ostream& out
) {
  const std::vector<std::string> cells = cells_of_row(row);
  if (cells.size() < 3) return;
  std::string meant;
  for (const std::string& word : words_in_cell(cells[0]))
    if (word_means(name, word)) meant += "  " + word + '\n';
  if (meant.empty()) return;
  out << file << " of a run\n" << meant << "      " << without_marks(cells[2]) << '\n';
  if (!cells[1].empty() && cells[1] != "-") out << "      in " << cells[1] << '\n';
}

}  // namespace

std::string describe_result(const std::string& page, const std::string& name) {
  std::istringstream in(page);
  std::ostringstream out;
  std::string file;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(begin_mark, 0) == 0) {
      const std::string rest = line.substr(std::string(begin_mark).size());
      file = rest.substr(0, rest.find(' '));
    } else if (line == end_mark) {
      file.clear();
    } else if (!file.empty() && line.rfind("| `", 0) == 0) {
      describe_row(line, file, name, out);
    }
  }
  return out.str();
}

std::string result_page() {
  std::error_code ignored;
  std::vector<fs::path> pages;
  fs::path folder = fs::canonical("/proc/self/exe", ignored).parent_path();
  constexpr int deepest = 2;  // bin, or a folder in it
  for (int i = 0; i < deepest && folder.has_relative_path(); ++i) {
    folder = folder.parent_path();
    pages.push_back(folder / "share/doc/barreno/docs/output.md");
  }
  pages.push_back(fs::path(BARRENO_DOCS_FOLDER) / "output.md");
  for (const fs::path& page : pages) {
    std::ifstream in(page);
    if (!in) continue;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  return {};
}

}  // namespace barreno
