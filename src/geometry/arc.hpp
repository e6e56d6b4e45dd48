// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace barreno {

/// Corners of a polygon that stand for the arc from a to b through a point between them; a and b
/// are left out. Its chords are of at most `longest_chord`, and `fewest_chords` or more. The
/// corners lie so far outside the circle that chords and arc enclose the same area: no chord is
/// further from the arc than `chord_tolerance` of its radius. From b to a they are the same to the
/// last bit, so that two figures on either side of an arc neither overlap nor leave a gap.
/// @return  nothing if the three points lie on a line: no arc goes through them
std::vector<std::array<double, 2>> corners_of_arc(
    const std::array<double, 2>& a,
    const std::array<double, 2>& through,
    const std::array<double, 2>& b
);

inline constexpr double longest_chord = 0.017453292519943295;  ///< 1 degree of the circle
inline constexpr int fewest_chords = 8;
inline constexpr double chord_tolerance = 3e-5;

}  // namespace barreno
