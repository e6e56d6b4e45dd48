// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/porous_medium.hpp"

#include <array>
#include <vector>

namespace barreno {

/// What a cell holds of porous rock: sums over its particles in the order of materials and ids, so
/// that they do not depend on ranks. Doubles only, ranks exchange it.
struct PoreCell {
  double storage = 0.0;   ///< sum V / M, fluid at its initial density; 0: solid, but without fluid
                          ///< [volume/stress]
  double pressure = 0.0;  ///< mean of p, weight V / M [stress]
  double volume = 0.0;    ///< of rock [volume]
  double gap = 0.0;       ///< of gas in its pores, fluid at its initial density [volume]
  double gap_pressure = 0.0;  ///< rise of the pressure that fills it [stress]
  double content = 0.0;       ///< fluid that can leave, at its initial density [volume]
  Vector centroid{};          ///< weight V / M [length]
  Vector lower{}, upper{};    ///< of the part of the cell that rock fills [length]
  Vector mobility{};          ///< k / viscosity along the axes, fluid at its initial density
                              ///< [length^2/(stress time)]
};

/// The cells that hold solid material.
struct PoreCells {
  int own = 0;                 ///< of this rank, then those next to them of other ranks
  std::vector<long long> ids;  ///< number of the cell in the box
  std::vector<PoreCell> cells;
  std::vector<char> filled;   ///< own cells whose gap this solve fills: its storage is that of full
                              ///< pores then, and the gap is taken beside it
  std::vector<char> emptied;  ///< own cells that this solve empties: all content leaves, no storage
  std::vector<int> index_of_key;         ///< Particles::key -> own cell, or -1
  std::vector<std::array<int, 6>> next;  ///< neighbours of own cells by Face; -1: nothing solid
};

/// Position of a cell in the box, in cells, from its id.
std::array<int, 3> place_of_cell(const Grid& grid, long long id);

/// Find the own cells with solid material and sum up their rock. Rock is what drains (is_drainable)
/// and has a permeability, or none.
/// @return whether they are the cells of the last time
bool fill_pore_cells(const PorousMedium& medium, PoreCells& cells);

/// Sum up once more with other cells `filled`.
void sum_pore_cells(const PorousMedium& medium, PoreCells& cells);

}  // namespace barreno
