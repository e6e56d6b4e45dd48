// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/decimal_marks.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <cctype>

namespace barreno {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The number that a cell begins with, before its exponent and its unit; empty where it is text.
std::string digits_of(const std::string& cell) {
  const std::size_t begin = cell.find_first_not_of("+-");
  if (begin > 1) return "";  // or there is none
  std::size_t end = begin;
  bool any = false;
  for (; end < cell.size() && (is_digit(cell[end]) || cell[end] == '.' || cell[end] == ','); ++end)
    any = any || is_digit(cell[end]);
  return any ? cell.substr(begin, end - begin) : "";
}

/// "12,345" or "1,234,567", in which the mark may stand between thousands.
bool in_thousands(const std::string& digits, char mark) {
  std::size_t group = digits.find(mark);
  if (group == std::string::npos || group == 0 || group > 3 || digits[0] == '0') return false;
  while (group != std::string::npos) {
    const std::size_t next = digits.find(mark, group + 1);
    const std::size_t end = next == std::string::npos ? digits.size() : next;
    if (end - group != 4) return false;
    for (std::size_t i = group + 1; i < end; ++i)
      if (!is_digit(digits[i])) return false;
    group = next;
  }
  return true;
}

bool has(const std::string& digits, char mark) {
  return digits.find(mark) != std::string::npos;
}

/// What the numbers of a table show of a comma and a point.
struct Marks {
  std::string first_with[2];  ///< a number with a comma, with a point
  int line_with[2] = {0, 0};
  bool thousands[2] = {true, true};   ///< each number that has the mark could have it there
  bool repeated[2] = {false, false};  ///< a number has the mark twice
  bool last[2] = {false, false};      ///< the mark is the second of both in a number
};

Marks marks_of(const TableText& table) {
  Marks marks;
  for (const TableLine& row : table.rows)
    for (const std::string& cell : row.cells) {
      const std::string digits = digits_of(cell);
      const bool both = has(digits, ',') && has(digits, '.');
      for (const int k : {0, 1}) {
        const char mark = ",."[k];
        if (!has(digits, mark)) continue;
        if (marks.line_with[k] == 0) marks.first_with[k] = digits, marks.line_with[k] = row.number;
        marks.repeated[k] = marks.repeated[k] || std::count(digits.begin(), digits.end(), mark) > 1;
        const std::size_t other = digits.find(",."[1 - k]);
        if (both && digits.rfind(mark) > other) {
          marks.last[k] = true;
        } else if (!in_thousands(digits.substr(0, both ? other : digits.size()), mark)) {
          marks.thousands[k] = false;
        }
      }
    }
  return marks;
}

enum class Decimal { point, comma, open, contradictory };

/// A mark that stands twice in a number, or before the other one, is not the decimal one.
Decimal decimal_of(const Marks& marks) {
  const bool comma = marks.line_with[0] > 0, point = marks.line_with[1] > 0;
  const bool not_comma = marks.repeated[0] || marks.last[1];
  const bool not_point = marks.repeated[1] || marks.last[0];
  if (not_comma && not_point) return Decimal::contradictory;
  if (not_comma) return marks.thousands[0] ? Decimal::point : Decimal::contradictory;
  if (not_point) return marks.thousands[1] ? Decimal::comma : Decimal::contradictory;
  if (comma && point) {
    if (marks.thousands[0] && !marks.thousands[1]) return Decimal::point;
    if (marks.thousands[1] && !marks.thousands[0]) return Decimal::comma;
    return Decimal::contradictory;
  }
  if (!comma) return Decimal::point;
  return marks.thousands[0] ? Decimal::open : Decimal::comma;
}

Decimal said_decimal(const TableText& table, const std::string& source) {
  for (const TableComment& comment : table.comments) {
    if (comment.key != "decimal") continue;
    const std::string word = lower_case(comment.value);
    if (word == "comma") return Decimal::comma;
    if (word == "point") return Decimal::point;
    input::refuse_value(
        source,
        "line " + std::to_string(comment.line) + ", decimal",
        comment.value,
        "is neither comma nor point; write one of the two"
    );
  }
  return Decimal::open;
}

[[noreturn]] void refuse_marks(const Marks& marks, Decimal found, const std::string& source) {
  const std::string line = "line " + std::to_string(marks.line_with[0]);
  if (found == Decimal::open)
    input::refuse(
        source,
        line,
        "has \"" + marks.first_with[0] +
            "\" (a decimal comma, or a comma between thousands); say which with a line "
            "\"# decimal: comma\" or \"# decimal: point\""
    );
  input::refuse(
      source,
      line,
      "has \"" + marks.first_with[0] + "\" and line " + std::to_string(marks.line_with[1]) +
          " has \"" + marks.first_with[1] +
          "\" (a table has one decimal mark); write its numbers with one"
  );
}

std::string with_point(const std::string& cell, bool comma) {
  const std::string digits = digits_of(cell);
  if (digits.empty()) return cell;
  std::string written;
  for (const char c : digits) {
    if (c == (comma ? ',' : '.')) written += '.';
    if (is_digit(c)) written += c;
  }
  const std::size_t begin = cell.find(digits);
  return cell.substr(0, begin) + written + cell.substr(begin + digits.size());
}

}  // namespace

void put_decimal_points(TableText& table, const std::string& source) {
  const Marks marks = marks_of(table);
  const bool has_comma = marks.line_with[0] > 0, has_point = marks.line_with[1] > 0;
  const Decimal said = said_decimal(table, source);
  Decimal decimal = said == Decimal::open ? decimal_of(marks) : said;
  if (said == Decimal::comma && !marks.thousands[1]) decimal = Decimal::contradictory;
  if (said == Decimal::point && !marks.thousands[0]) decimal = Decimal::contradictory;
  // A mark by itself that makes no number is named with its cell, where numbers are read.
  if (decimal == Decimal::contradictory && !(has_comma && has_point)) return;
  if (decimal == Decimal::open || decimal == Decimal::contradictory)
    refuse_marks(marks, decimal, source);
  const bool comma = decimal == Decimal::comma;
  if (!comma && !has_comma) return;
  for (TableLine& row : table.rows)
    for (std::string& cell : row.cells) cell = with_point(cell, comma);
  if (said != Decimal::open) return;
  if (comma) table.notes.emplace_back("the decimal mark is the comma.");
  if (comma ? has_point : has_comma)
    table.notes.push_back(std::string(comma ? "points" : "commas") + " stand between thousands.");
}

}  // namespace barreno
