// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace barreno {

/// Piecewise-linear function of time, constant outside its range.
struct Table {
  std::vector<double> time{0.0}, value{0.0};
  double operator()(double t) const;
};

/// What decks call the columns of a table, and the pressure that is given without one.
inline constexpr const char* times_word = "Times";
inline constexpr const char* factors_word = "Factors";
inline constexpr const char* pressures_word = "Pressures";
inline constexpr const char* pressure_word = "Pressure";

}  // namespace barreno
