// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// Numbers that were measured, installed with the program as CSV files (src/measured): comments, a
/// header, rows of a name and numbers, and a last line "# end of N rows". The scripts of
/// verification write these files.
struct MeasuredTable {
  struct Row {
    std::string name;
    std::vector<double> numbers;
  };
  std::vector<Row> rows;  ///< none if there is a problem: half a table would give wrong numbers
  std::string problem;    ///< why nothing is known, for a sentence; empty: the table is whole
};

/// @param columns  of the header: that of the name, then those of the numbers; a name may hold
///                 commas
/// @param folder  where the file is; empty: where it is installed. Never throws for a file.
MeasuredTable read_measured(
    const std::string& name,
    const std::vector<std::string>& columns,
    const std::filesystem::path& folder = {}
);

}  // namespace barreno
