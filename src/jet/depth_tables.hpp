// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// What the cells were measured to do to the depth of a tungsten jet in Berea sandstone, from
/// src/measured/depths_of_cells.csv, steady_errors.csv, length_errors.csv and
/// divided_errors.csv.

/// The jet of perforation_120us.xml, whose depths were measured: its tip.
inline constexpr double measured_radius = 1e-3;      ///< [length]
inline constexpr double measured_velocity = 7830.0;  ///< [velocity]

struct MeasuredDepths {
  double cell = 0.0;          ///< [length]
  std::vector<double> depth;  ///< at DepthTables::times; 0: not measured [length]
};
/// Range of the error of steady penetration.
struct SteadyError {
  double cells_per_radius = 0.0, low = 0.0, high = 0.0;
};
/// Errors of the depth, with the two DepthTables::length_cells, of jets of the same mass and
/// momentum whose slugs are shorter or longer.
struct LengthError {
  double length_over_radius = 0.0;  ///< of the first slug
  std::array<double, 2> error{};
};

/// Error of a jet's depth that comes from the size of the cells, depth over true depth less 1.
struct DepthError {
  double value = 0.0;            ///< what perforation_120us.xml had at the same cells and depth
  double low = 0.0, high = 0.0;  ///< range of all measurements with the same cells
};
/// Of jets that break, with particles that are divided (jet/divided_error.hpp).
struct DividedError {
  double cells_per_radius = 0.0;
  DepthError depth, resting;  ///< of the tip: until a time that was measured, and of a hole at rest
  DepthError probed, volume, efficiency;
};

struct DepthTables {
  std::string problem;                 ///< why nothing is known, for a sentence; empty: it is
  std::vector<double> times;           ///< [time]
  std::vector<MeasuredDepths> depths;  ///< the last is what the others are compared with
  /// What estimate_jet() finds at those times, so that an estimate can stand for a depth [length].
  std::vector<double> estimated;
  /// With cells half as large as the last at those times, 0: not measured: what the comparison is
  /// worth [length].
  std::vector<double> finest;
  std::vector<SteadyError> steady;  ///< rows as those of depths
  std::array<double, 2> length_cells{};
  std::vector<LengthError> lengths;   ///< the shortest slugs first
  std::size_t own_length = 0;         ///< which of them is of the slugs of `depths`
  std::vector<DividedError> divided;  ///< the largest cells first
};

/// @param folder  of the files; empty: where they are installed. Files that are missing, broken or
///                do not fit together give a problem and no numbers.
DepthTables read_depth_tables(const std::filesystem::path& folder = {});

/// Those that are installed, read once.
const DepthTables& depth_tables();

}  // namespace barreno
