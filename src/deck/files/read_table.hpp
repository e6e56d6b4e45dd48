// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
};

/// A CSV table's text in SI. The first line that is neither empty nor a '#' comment is the header,
/// which must be the columns' names in their order; a comment "# units: mm-us-g" names the system
/// of the plain numbers (default SI).
/// @param what  "a jet table", for sentences
/// Throws DeckError with the line's number and the column's name.
TableRows read_table(
    const std::string& text,
    const std::vector<TableColumn>& columns,
    const std::string& what,
    const std::string& source
);

}  // namespace barreno
