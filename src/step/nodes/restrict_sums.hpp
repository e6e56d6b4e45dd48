// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/nodes.hpp"

namespace barreno {

/// Adds what particles of refined tiles have given to nodes that are no unknowns of theirs
/// (Grid::from_parent) to the nodes of the coarser lattice that these stand for: m_J += c_IJ m_I,
/// and momentum and force alike, with the coefficients c of for_each_coarse_node. The velocities
/// come back with the same ones (solve_velocity), so that mass, momentum and the work of forces are
/// kept. From the finest level on, before ranks exchange their sums. docs/method.md 11
///
/// Nothing to do where all tiles have one level.
void restrict_sums(const Grid& grid, const Nodes& nodes);

}  // namespace barreno
