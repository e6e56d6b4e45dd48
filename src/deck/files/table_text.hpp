// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace barreno {

/// A line of a table and its cells, without blanks at their ends and without quotes.
struct TableLine {
  int number = 0;
  std::vector<std::string> cells;
};

/// A comment "# key: value".
struct TableComment {
  int line = 0;
  std::string key, value;
};

/// A table as text: what spreadsheets and laboratories vary is settled here, and numbers have a
/// decimal point. src/python/barreno/fit/table.py follows the same rules for the files of
/// `fit`; tests/decks/test_table_variants.py gives both the same files.
struct TableText {
  int header_line = 0;                    ///< 0: the text has no header
  std::string header;                     ///< as it stands
  std::vector<std::string> names, units;  ///< of the columns; a unit is empty where none is given
  std::vector<TableLine> rows;
  std::vector<TableComment> comments;
  std::vector<std::string> notes;  ///< what was guessed, a sentence each
};

/// Text of a file in UTF-8, without a byte-order mark: UTF-16 with a mark and Latin-1 are
/// converted.
std::string text_in_utf8(const std::string& bytes);

std::string lower_case(std::string text);

/// Power of ten of a unit that only ratios have: "%", "permille", "microstrain".
std::optional<int> scale_of_ratio(const std::string& unit);

/// Splits a table. Cells are separated by the sign that most lines have: semicolon, tab or comma.
/// The header is the first line with one of the names that are known; capitals do not matter.
/// @throws DeckError where the marks in numbers leave open what they mean
TableText split_table(
    const std::string& bytes, const std::vector<std::string>& known, const std::string& source
);

/// Whether the header, or what stands in its place, has a column of this name.
bool has_column(const TableText& table, const std::string& name);

}  // namespace barreno
