// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/linear_solver.hpp"
#include "pore_flow/pore_cells.hpp"
#include "pore_flow/pore_halo.hpp"
#include "pore_flow/pore_links.hpp"

#include <array>
#include <barreno/pore_point.hpp>
#include <memory>
#include <vector>

namespace barreno {

/// A particle of rock while it drains.
struct PoreShare {
  PorePoint point;
  double wanted = 0.0;  ///< fluid that comes in by (7.4), per volume
};
struct PoreShares {
  std::vector<PoreShare> points;  ///< in the order of for_each_solid_row, material by material
  /// Of own cells, volumes at the initial density:
  std::vector<double> lacking;  ///< what points are asked for beyond what they hold [volume]
  std::vector<double> spare;    ///< what the others would still hold [volume]
  std::vector<double> evened;   ///< how far the pressures within a cell have come to a line [-]
};

/// Scratch of the pore flow, kept from solve to solve for its memory and its graph.
struct PoreNetwork {
  PoreCells cells;
  std::shared_ptr<PoreHalo> halo;
  std::vector<std::array<PoreLink, 6>> links;  ///< of own cells by Face
  LinearSystem system;
  std::shared_ptr<LinearSolver> solver;
  std::vector<double> change;     ///< dp of all cells, others' included [stress]
  std::vector<double> steepness;  ///< share of its slope that a cell may have, see cell_steepness
  std::vector<Vector> flux;       ///< Darcy velocity of own cells [velocity]
  PoreShares shares;
};

}  // namespace barreno
