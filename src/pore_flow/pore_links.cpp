// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/pore_links.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// One side of a face.
struct HalfLink {
  double resistance = 0.0;  ///< [stress time/volume]
  double area = 0.0;        ///< where it ends
};

/// From the centroid of a cell's rock to a plane across axis d. In axisymmetry cross sections along
/// r grow with it: the integral of dr / (A r).
HalfLink half_link(const Grid& grid, const PoreCell& cell, std::size_t d, double plane) {
  constexpr double shortest = 1e-3;  // cells: a centroid never lies in a face but for round-off
  const double thickness = std::max(cell.upper[d] - cell.lower[d], shortest * grid.cell_size);
  const double section = cell.volume / thickness;
  const double length = std::max(std::abs(plane - cell.centroid[d]), shortest * grid.cell_size);
  const double conduction = cell.mobility[d] * section;
  if (grid.mode != Mode::axisymmetric || d != 0 || !(plane > 0.0))
    return {length / conduction, section};
  const double r = cell.centroid[d];
  return {
      r * std::abs(std::log1p((plane < r ? -length : length) / r)) / conduction,
      section * plane / r};
}

/// rho g . (to - from) along axis d: what a column of fluid at rest adds on the way.
double column(const PoreFlowSpec& flow, std::size_t d, double from, double to) {
  return flow.fluid_weight[d] * (to - from);
}

const PoreConditionSpec* condition_at(
    const PoreFlowSpec& flow, std::size_t face, bool end_of_grid
) {
  for (const PoreConditionSpec& condition : flow.conditions)
    if (end_of_grid ? condition.grid_faces[face] : condition.open_faces[face]) return &condition;
  return nullptr;
}

/// Where rock ends: at the face of the box, or where it stops in its cell.
PoreLink link_to_outside(
    const PorousMedium& medium, const PoreCell& cell, std::size_t face, bool end
) {
  PoreLink link;
  const Grid& grid = medium.grid;
  const PoreConditionSpec* const condition = condition_at(medium.flow, face, end);
  if (condition == nullptr) return link;
  const std::size_t d = face / 2;
  const double plane = end ? (face % 2 == 0 ? grid.lower[d] : grid.upper[d])
                           : (face % 2 == 0 ? cell.lower[d] : cell.upper[d]);
  const HalfLink half = half_link(grid, cell, d, plane);
  link.area = half.area;
  if (condition->kind == PoreConditionKind::flux) {
    link.prescribed_flow = condition->value(medium.time) * half.area;
  } else if (cell.mobility[d] > 0.0) {
    link.conductance = 1.0 / half.resistance;
    link.outside = condition->value(medium.time) + column(medium.flow, d, plane, cell.centroid[d]);
  }
  return link;
}

}  // namespace

PoreLink pore_link(
    const PorousMedium& medium, const PoreCells& cells, std::size_t i, std::size_t face
) {
  const Grid& grid = medium.grid;
  const PoreCell& cell = cells.cells[i];
  const std::size_t d = face / 2;
  const int at = place_of_cell(grid, cells.ids[i])[d];
  const int next = cells.next[i][face];
  const bool end = face % 2 == 0 ? at == 0 : at == grid.cells[d] - 1;
  if (next < 0) return link_to_outside(medium, cell, face, end);
  PoreLink link;
  const PoreCell& other = cells.cells[static_cast<std::size_t>(next)];
  if (!(other.storage > 0.0 && cell.mobility[d] > 0.0 && other.mobility[d] > 0.0)) return link;
  const double plane = grid.lower[d] + (at + static_cast<int>(face % 2)) * grid.cell_size;
  // Both ranks of a face add the halves in one order.
  const HalfLink here = half_link(grid, cell, d, plane), there = half_link(grid, other, d, plane);
  link.conductance = 1.0 / (here.resistance + there.resistance);
  link.area = std::min(here.area, there.area);
  link.cell = next;
  link.outside = column(medium.flow, d, other.centroid[d], cell.centroid[d]);
  return link;
}

}  // namespace barreno
