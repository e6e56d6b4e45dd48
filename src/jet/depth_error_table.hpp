// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace barreno {

/// What the cells were measured to do to the depth of a tungsten jet in Berea sandstone. A test
/// compares these numbers with their files in verification/results.

/// Depths of perforation.xml, whose jet has a tip of 1 mm radius (perforation_cells.csv).
inline constexpr double measured_radius = 1e-3;      ///< [length]
inline constexpr double measured_velocity = 7830.0;  ///< of its tip [velocity]
inline constexpr std::array<double, 7> measured_times{
    5e-6, 10e-6, 20e-6, 30e-6, 50e-6, 70e-6, 90e-6};  ///< [time]
struct MeasuredDepths {
  double cell = 0.0;              ///< [length]
  std::array<double, 7> depth{};  ///< at measured_times; 0: not measured [length]
};
/// The last row is what the others are compared with.
inline constexpr std::array<MeasuredDepths, 4> measured_depths{{
    {2e-3, {13.87e-3, 33.18e-3, 65.9e-3, 0.0, 132.9e-3, 0.0, 182.6e-3}},
    {1e-3, {18.59e-3, 40.9e-3, 78.2e-3, 109.3e-3, 159.2e-3, 200.1e-3, 232.3e-3}},
    {0.5e-3, {20.28e-3, 43.69e-3, 85.3e-3, 0.0, 181.0e-3, 0.0, 268.2e-3}},
    {0.25e-3, {20.74e-3, 44.1e-3, 85.5e-3, 120.8e-3, 180.4e-3, 229.5e-3, 271.5e-3}},
}};
/// What estimate_jet() finds at those times, so that an estimate can stand for a depth [length].
inline constexpr std::array<double, 7> estimated_depths{
    20.09e-3, 42.90e-3, 79.48e-3, 108.00e-3, 149.25e-3, 178.43e-3, 199.63e-3};
/// With cells of 0.125 mm at those times, 0: not measured: what the comparison is worth [length].
inline constexpr std::array<double, 7> finest_depths{
    20.45e-3, 43.8e-3, 84.56e-3, 119.93e-3, 0.0, 0.0, 0.0};

/// Range of the error of steady penetration (steady_penetration.csv), rows as above.
struct SteadyError {
  double cells_per_radius, low, high;
};
inline constexpr std::array<SteadyError, 4> steady_errors{
    {{0.5, -0.29, -0.16}, {1.0, -0.15, -0.03}, {2.0, -0.04, 0.02}, {4.0, 0.0, 0.0}}};

/// Errors of the depth at the second of the times, with 1 and 2 cells per radius, of jets of the
/// same mass and momentum whose slugs are shorter or longer (slug_length.json).
struct LengthError {
  double length_over_radius;  ///< of the first slug
  std::array<double, 2> error;
};
inline constexpr std::array<double, 2> length_error_cells{1.0, 2.0};
inline constexpr std::array<LengthError, 3> length_errors{{
    {0.50341881, {-0.0713, -0.0082}},
    {1.00683761, {-0.0723, -0.0096}},
    {1.99703944, {-0.0653, -0.0041}},
}};
/// Which of them is of the slugs of measured_depths.
inline constexpr std::size_t measured_length = 1;

}  // namespace barreno
