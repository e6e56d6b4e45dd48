// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/table_text.hpp"

#include "base/utf8.hpp"
#include "deck/files/decimal_marks.hpp"

#include <algorithm>
#include <barreno/input/error.hpp>
#include <barreno/input/scan_xml.hpp>
#include <barreno/input/units.hpp>
#include <cctype>
#include <sstream>

namespace barreno {
namespace {

const char* const blanks = " \t\r";

std::string trimmed(const std::string& text, const char* signs = blanks) {
  const std::size_t begin = text.find_first_not_of(signs);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(signs) - begin + 1);
}

void append_utf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80U) return add(code);
  if (code < 0x800U) {
    add(0xC0U | (code >> 6U));
  } else {
    add(0xE0U | (code >> 12U));
    add(0x80U | ((code >> 6U) & 0x3FU));
  }
  add(0x80U | (code & 0x3FU));
}

/// Characters beyond U+FFFF, which no table of numbers has, become question marks.
std::string from_utf16(const std::string& bytes, bool big_endian) {
  std::string out;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    const unsigned high = big_endian ? first : second, low = big_endian ? second : first;
    const unsigned code = (high << 8U) | low;
    append_utf8(out, code >= 0xD800U && code < 0xE000U ? '?' : code);
  }
  return out;
}

/// Lines without what ends them; "\r" alone ends one too.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    if (text[i] == '\n' || text[i] == '\r')
      lines.emplace_back();
    else
      lines.back() += text[i];
  }
  return lines;
}

bool has_outside_quotes(const std::string& line, char sign) {
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == sign && !quoted) return true;
  }
  return false;
}

/// Between blanks; "Stress [MPa]" is one word.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    if (!words.empty() && (word[0] == '[' || word[0] == '('))
      words.back() += word;
    else
      words.push_back(word);
  }
  return words;
}

/// Two numbers at least, whatever the marks in them mean.
bool is_row_of_numbers(const std::vector<std::string>& words) {
  const auto is_number = [](const std::string& word) {
    const std::size_t begin = word[0] == '+' || word[0] == '-' ? 1 : 0;
    const std::size_t end = word.find_first_not_of("0123456789.,", begin);
    const std::string rest = end == std::string::npos ? "" : word.substr(end);
    const std::string digits = word.substr(begin, end == std::string::npos ? end : end - begin);
    const bool exponent =
        rest.size() > 1 && (rest[0] == 'e' || rest[0] == 'E') &&
        rest.find_first_not_of("0123456789", rest[1] == '+' || rest[1] == '-' ? 2 : 1) ==
            std::string::npos;
    return digits.find_first_of("0123456789") != std::string::npos && digits.back() != ',' &&
           (rest.empty() || exponent);
  };
  return words.size() > 1 && std::all_of(words.begin(), words.end(), is_number);
}

/// More than half of the lines of the second half, where titles are not, have it.
char separator_of(const std::vector<TableLine>& lines) {
  const std::size_t begin = lines.size() / 2;
  for (const char sign : {';', '\t'}) {
    std::size_t with = 0;
    for (std::size_t i = begin; i < lines.size(); ++i)
      if (has_outside_quotes(lines[i].cells[0], sign)) ++with;
    if (2 * with > lines.size() - begin) return sign;
  }
  for (std::size_t i = begin; i < lines.size(); ++i)
    if (!is_row_of_numbers(words_of(lines[i].cells[0]))) return ',';
  return ' ';
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  if (separator == ' ') return words_of(line);
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

bool all_empty(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const std::string& c) { return c.empty(); });
}

/// "Axial strain" as "axial_strain".
std::string name_of(const std::string& cell) {
  std::string name = lower_case(cell);
  for (char& c : name)
    if (c == ' ' || c == '-') c = '_';
  return name;
}

/// "Velocity [km/s]" or "Velocity (km/s)".
struct NameAndUnit {
  std::string name, unit;
};
NameAndUnit parts_of(const std::string& cell) {
  for (const char* brackets : {"[]", "()"}) {
    const std::size_t open = cell.rfind(brackets[0]);
    if (open == std::string::npos || open == 0 || cell.back() != brackets[1]) continue;
    return {
        name_of(trimmed(cell.substr(0, open))),
        trimmed(cell.substr(open + 1, cell.size() - open - 2))};
  }
  return {name_of(cell), ""};
}

bool is_header(const std::vector<std::string>& cells, const std::vector<std::string>& known) {
  return std::any_of(cells.begin(), cells.end(), [&](const std::string& cell) {
    const std::string name = parts_of(cell).name;
    return std::any_of(known.begin(), known.end(), [&](const std::string& word) {
      return lower_case(word) == name;
    });
  });
}

bool is_unit(const std::string& text) {
  if (text.empty() || text == "-" || scale_of_ratio(text)) return true;
  if (text.find_first_of("0123456789") == 0) return false;
  try {
    input::read_unit(text);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool is_unit_row(const std::vector<std::string>& cells) {
  return !all_empty(cells) && std::all_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return is_unit(trimmed(cell, " []()"));
  });
}

/// No cell begins with a number.
bool is_text_row(const std::vector<std::string>& cells) {
  return std::none_of(cells.begin(), cells.end(), [](const std::string& cell) {
    const std::size_t begin = cell.find_first_not_of("+-.,");
    return begin < 3 && std::isdigit(static_cast<unsigned char>(cell[begin])) != 0;
  });
}

void take_comment(const std::string& line, int number, TableText& table) {
  const std::size_t colon = line.find(':');
  if (colon == std::string::npos) return;
  table.comments.push_back(
      {number, lower_case(trimmed(line.substr(1, colon - 1))), trimmed(line.substr(colon + 1))}
  );
}

void take_header(const TableLine& line, TableText& table) {
  for (const std::string& cell : line.cells) {
    const NameAndUnit parts = parts_of(cell);
    table.names.push_back(parts.name);
    table.units.push_back(parts.unit);
  }
  while (!table.names.empty() && table.names.back().empty()) {
    table.names.pop_back();
    table.units.pop_back();
  }
  table.header_line = line.number;
}

/// Of the rows of text below the names the one that holds units; further ones, channels for
/// instance, are not read.
void take_unit_row(TableText& table) {
  if (!all_empty(table.units)) return;
  std::size_t texts = 0, found = 0;
  while (texts < table.rows.size() && is_text_row(table.rows[texts].cells)) ++texts;
  while (found < texts && !is_unit_row(table.rows[found].cells)) ++found;
  if (found == texts) return;
  const TableLine units = table.rows[found];
  for (std::size_t i = 0; i < table.units.size() && i < units.cells.size(); ++i)
    table.units[i] = trimmed(units.cells[i], " []()");
  if (texts > 1)
    table.notes.push_back(
        "text below the column names is not read: line " +
        std::to_string(table.rows[found == 0 ? 1 : 0].number) + "."
    );
  table.rows.erase(table.rows.begin(), table.rows.begin() + static_cast<std::ptrdiff_t>(texts));
}

/// A spreadsheet fills short rows up with empty cells.
void drop_filling(TableText& table) {
  const std::size_t width = table.names.size();
  for (TableLine& row : table.rows)
    while (row.cells.size() > width && row.cells.back().empty()) row.cells.pop_back();
}

std::string line_words(const std::vector<int>& numbers) {
  const std::string first = std::to_string(numbers.front());
  if (numbers.size() == 1) return "line " + first + " stands";
  return "lines " + first + " to " + std::to_string(numbers.back()) + " stand";
}

}  // namespace

std::optional<int> scale_of_ratio(const std::string& unit) {
  if (unit == "%" || unit == "percent") return -2;
  if (unit == "\xE2\x80\xB0" || unit == "permille" || unit == "millistrain") return -3;
  if (unit == "microstrain" || unit == "ustrain") return -6;
  return std::nullopt;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string text_in_utf8(const std::string& bytes) {
  if (bytes.compare(0, 2, "\xFF\xFE") == 0) return from_utf16(bytes, false);
  if (bytes.compare(0, 2, "\xFE\xFF") == 0) return from_utf16(bytes, true);
  return as_utf8(bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? bytes.substr(3) : bytes);
}

TableText split_table(
    const std::string& bytes, const std::vector<std::string>& known, const std::string& source
) {
  const std::string text = text_in_utf8(bytes);
  if (text.find('\0') != std::string::npos)
    input::refuse(source, "", "is not text (it holds a zero byte); is it the right file?");
  TableText table;
  std::vector<TableLine> lines;  // each as one cell
  int number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    const std::string packed = trimmed(line);
    if (packed.empty()) continue;
    if (packed.front() == '#')
      take_comment(packed, number, table);
    else
      lines.push_back({number, {line}});
  }
  if (lines.empty()) return table;
  const char separator = separator_of(lines);
  if (separator != ',')
    table.notes.push_back(
        std::string("cells are separated by ") + (separator == ';'   ? "semicolons."
                                                  : separator == ' ' ? "blanks."
                                                                     : "tabs.")
    );
  std::vector<std::string> as_they_stand;
  for (TableLine& line : lines) {
    as_they_stand.push_back(trimmed(line.cells[0]));
    line.cells = cells_of(line.cells[0], separator);
  }
  std::size_t at = 0;
  while (at < lines.size() && !is_header(lines[at].cells, known)) ++at;
  if (at == lines.size()) at = 0;  // to be refused by who knows the columns
  std::vector<int> skipped;
  for (std::size_t i = 0; i < at; ++i) skipped.push_back(lines[i].number);
  if (!skipped.empty())
    table.notes.push_back(line_words(skipped) + " above the column names and is not read.");
  take_header(lines[at], table);
  table.header = as_they_stand[at];
  for (std::size_t i = at + 1; i < lines.size(); ++i)
    if (!all_empty(lines[i].cells)) table.rows.push_back(lines[i]);
  take_unit_row(table);
  drop_filling(table);
  put_decimal_points(table, source);
  return table;
}

bool has_column(const TableText& table, const std::string& name) {
  return std::find(table.names.begin(), table.names.end(), lower_case(name)) != table.names.end();
}

}  // namespace barreno
