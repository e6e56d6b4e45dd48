// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/pore_cells.hpp"

namespace barreno {

/// What one face of a cell lets through: flow into the cell is
///
///   conductance * (outside - p) + prescribed_flow,   outside: the pressure beyond, weight included
///
/// with the pressure of the cell next to it where there is one [volume/time].
struct PoreLink {
  double conductance = 0.0;  ///< [volume/(stress time)]; 0: sealed
  int cell = -1;             ///< next to it, or -1: `outside` is prescribed
  double outside = 0.0;      ///< without a cell the pressure; with one what its fluid column adds
                             ///< [stress]
  double prescribed_flow = 0.0;  ///< flux through the face [volume/time]
  double area = 0.0;             ///< of rock in the face
};

/// The link of own cell i through a face. Two half cells in series, each with the mean cross
/// section of its rock and the distance from its centroid: exact for layers of any thickness.
PoreLink pore_link(
    const PorousMedium& medium, const PoreCells& cells, std::size_t i, std::size_t face
);

}  // namespace barreno
