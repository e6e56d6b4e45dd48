// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <barreno/tensor.hpp>
#include <string>
#include <vector>

namespace barreno {

/// One instant of a path in strain and stress, and what is prescribed on the way to it.
struct MixedRow {
  double time = 0.0;                ///< [s]
  std::array<double, 6> target{};   ///< logarithmic strain [-] or stress [Pa] of xx yy zz xy yz zx
  std::array<bool, 6> by_stress{};  ///< which of them are stresses
  bool drained = false;             ///< the pore pressure is prescribed: fluid flows in or out
  double pore_pressure = 0.0;       ///< [Pa], where it is drained
  int line = 0;                     ///< in the file, for sentences
};

/// A path on which every component of strain or of stress is prescribed, without rotation; which
/// of the two may change from row to row.
struct MixedPath {
  std::vector<MixedRow> rows;
  std::vector<std::string> notes;  ///< what was guessed of the table, a sentence each
};

inline constexpr std::array<const char*, 6> component_names = {"xx", "yy", "zz", "xy", "yz", "zx"};

/// Whether the header asks for strain, stress or pore pressure rather than F11 to F33.
bool is_mixed_path(const std::string& text, const std::string& source);

/// A path's text: header of `time` and any of strain_xx ... strain_zx, stress_xx ... stress_zx and
/// pore_pressure. A component without a column keeps a strain of zero; one with both columns has
/// one of them filled in each row, and an empty pore_pressure closes the rock for its fluid.
/// Columns of laboratories (laboratory_columns.hpp) prescribe the axis, xx, and both other axes.
///
/// Throws DeckError with line and column: header, text in a number, a component that is given twice
/// or not at all, too few rows, times that do not increase, strains at the first row.
MixedPath read_mixed_path(const std::string& text, const std::string& source);

}  // namespace barreno
