// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/tensor.hpp>
#include <string>
#include <vector>

namespace barreno {

/// One instant of a path.
struct PathRow {
  double time = 0.0;          ///< [s]
  Mat3 deformation_gradient;  ///< F [-]
  int line = 0;               ///< in the file, for sentences
};

/// A path's text: header time,F11,F12,F13,F21,F22,F23,F31,F32,F33, a row per instant, '#' comments.
///
/// Throws DeckError with line and column: header, text in a number, too few rows, times that do not
/// increase, det F <= 0.
/// @param notes  what was guessed of the table, a sentence each
std::vector<PathRow> read_path(
    const std::string& text, const std::string& source, std::vector<std::string>* notes = nullptr
);

/// What every path must fulfil: at least two rows, and times that increase.
void check_row_count(std::size_t count, const std::string& source);
void check_times(double before, int line_before, double time, int line, const std::string& source);

}  // namespace barreno
