// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace barreno {

/// Corners and arcs as somebody has given them, as the corners of a polygon.
struct DrawnPolygon {
  std::vector<std::array<double, 2>> corners;
  /// Which of the given edges begins at each of them or holds it; the edge from the first given
  /// corner to the second is number 1.
  std::vector<std::size_t> edges;
};

/// @param corners  rows {first coordinate, second}, in order
/// @param arcs  rows {number of an edge, a point of its arc}; other edges are straight
/// @param[out] problem  empty, or what is wrong with the arcs, for a sentence
DrawnPolygon draw_polygon(
    const std::vector<std::vector<double>>& corners,
    const std::vector<std::vector<double>>& arcs,
    std::string& problem
);

/// The numbers of two given edges that meet elsewhere than in a common corner, or nothing.
std::vector<std::size_t> crossing_edges(const DrawnPolygon& polygon);

}  // namespace barreno
