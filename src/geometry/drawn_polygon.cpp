// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/drawn_polygon.hpp"

#include "geometry/arc.hpp"

#include <cmath>

namespace barreno {
namespace {

using Point = std::array<double, 2>;
using GivenRows = std::vector<std::vector<double>>;

/// On which side of the line from a to b.
double side_of_line(const Point& a, const Point& b, const Point& x) {
  return (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
}

std::string numbered(std::size_t row) {
  return std::string("row ").append(std::to_string(row + 1));
}

/// What is wrong with the number of an arc's edge.
std::string problem_of_number(const GivenRows& arcs, std::size_t row, std::size_t edges) {
  const double number = arcs[row][0];
  if (!(number >= 1.0 && number <= static_cast<double>(edges) && number == std::floor(number)))
    return "has no edge for " + numbered(row) + " (edges are numbered from 1 to " +
           std::to_string(edges) + ", each as the corner that it starts from); correct the number";
  for (std::size_t before = 0; before < row; ++before)
    if (arcs[before][0] == number)
      return "has two arcs for one edge in " + numbered(before) + " and " + numbered(row) +
             "; remove one of them, or add a corner where they meet";
  return {};
}

/// The row of each edge's arc, from 1; 0: it is straight.
std::vector<std::size_t> arcs_of_edges(
    const GivenRows& arcs, std::size_t edges, std::string& problem
) {
  std::vector<std::size_t> rows(edges, 0);
  for (std::size_t row = 0; row < arcs.size() && problem.empty(); ++row) {
    problem = problem_of_number(arcs, row, edges);
    if (problem.empty()) rows[static_cast<std::size_t>(arcs[row][0]) - 1] = row + 1;
  }
  return rows;
}

}  // namespace

DrawnPolygon draw_polygon(const GivenRows& corners, const GivenRows& arcs, std::string& problem) {
  DrawnPolygon drawn;
  const std::vector<std::size_t> rows = arcs_of_edges(arcs, corners.size(), problem);
  if (!problem.empty()) return drawn;
  const auto corner = [&](std::size_t i) {
    return Point{corners[i % corners.size()][0], corners[i % corners.size()][1]};
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    drawn.corners.push_back(corner(i));
    drawn.edges.push_back(i + 1);
    if (rows[i] == 0) continue;
    const std::vector<double>& arc = arcs[rows[i] - 1];
    const std::vector<Point> between = corners_of_arc(corner(i), {arc[1], arc[2]}, corner(i + 1));
    if (between.empty()) {
      problem = "has a point in " + numbered(rows[i] - 1) +
                " that lies on the line through the ends of its edge (no circle goes through the "
                "three); move it, or remove the row";
      return drawn;
    }
    drawn.corners.insert(drawn.corners.end(), between.begin(), between.end());
    drawn.edges.insert(drawn.edges.end(), between.size(), i + 1);
  }
  return drawn;
}

std::vector<std::size_t> crossing_edges(const DrawnPolygon& polygon) {
  const auto& p = polygon.corners;
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const auto &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
      if (side_of_line(a, b, c) * side_of_line(a, b, d) < 0.0 &&
          side_of_line(c, d, a) * side_of_line(c, d, b) < 0.0)
        return {polygon.edges[i], polygon.edges[j]};
    }
  return {};
}

}  // namespace barreno
