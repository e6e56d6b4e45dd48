// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/linear_solver.hpp"

#include <optional>
#include <string>
#include <vector>

namespace barreno {

/// Rock around a hole on rings: cells between radii, in rows between depths. Cell (i, j) of column
/// i and row j has the index j * columns + i. Any consistent units.
struct RingCells {
  std::vector<double> radii, depths;  ///< edges, ascending; the first radius is 0 or more [length]
  std::vector<double> mobility;       ///< k / viscosity of every cell; 0: nothing flows there
  std::vector<char> hole;             ///< cells at the pressure of the hole
  double hole_pressure = 0.0;
  /// Pressures outside: of every row at the largest radius, of every column at the first and the
  /// last depth; empty: closed.
  std::vector<double> outside, above, below;

  std::size_t columns() const { return radii.size() - 1; }
  std::size_t rows() const { return depths.size() - 1; }
};

/// What is wrong with them, a sentence without a full stop; empty: nothing.
std::string problem_of(const RingCells& cells);

struct SteadyFlow {
  std::vector<double> pressure;   ///< of every cell; nan where nothing flows
  std::vector<double> into_hole;  ///< of every row [volume/time]
  double from_outside = 0.0, from_above = 0.0, from_below = 0.0;
  SolveReport report;
};

/// Steady flow after Darcy, div (k / viscosity grad p) = 0, by finite volumes. docs/method.md
///
///   radial face:  G = 2 pi dz / (ln(r_f / r_i) / m_i + ln(r_n / r_f) / m_n)
///   axial face:   G = pi (r_2^2 - r_1^2) / (dz_i / (2 m_i) + dz_n / (2 m_n))
///
/// with r_i the middle of a cell, m its mobility; beyond a face of the hole or of the outside the
/// second term is 0. Flow through rings is exact if it is radial, whatever their mobilities. Rock
/// that no way leads to from a pressure is left out. Collective; the result is on rank 0.
/// @param cells  the same on every rank, without a problem
SteadyFlow solve_steady_flow(
    const RingCells& cells, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
);

/// Reads the cells from a JSON file (docs/flow.md), solves, and writes pressures and flows as JSON.
/// Collective.
/// @throws DeckError, FileError  with one sentence
void solve_flow_file(
    const std::string& problem,
    const std::string& out,
    const Teuchos::RCP<const Teuchos::Comm<int>>& comm
);

}  // namespace barreno
