// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/files/table_text.hpp"

#include <barreno/describe.hpp>
#include <string>
#include <vector>

namespace barreno {

struct TableColumn {
  const char* name = "";
  Dimension dimension;
  bool may_be_empty = false;  ///< an empty cell is read as NaN, which no text gives
};

/// Numbers of a table, row after row, and the line of the file that each row stood in.
struct TableRows {
  std::vector<double> values;
  std::vector<int> lines;
  std::vector<std::string> notes;  ///< what was guessed, a sentence each
};

/// A table's text in SI, as TableText reads it. The first line that is not a '#' comment and has
/// one of the columns' names is the header, which must have each of them once, in any order. Units
/// stand behind the names, in a row below them or in cells; a comment "# units: mm-us-g" names the
/// system of the plain numbers (default SI). Ratios may be in percent.
/// @param what  "a jet table", for sentences
/// Throws DeckError with the line's number and the column's name.
TableRows read_table(
    const std::string& text,
    const std::vector<TableColumn>& columns,
    const std::string& what,
    const std::string& source
);

/// The same for a table that is split, whose columns are known.
/// @param columns  in the order of the file
TableRows read_rows(
    const TableText& table, const std::vector<TableColumn>& columns, const std::string& source
);

}  // namespace barreno
