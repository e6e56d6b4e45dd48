// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/nodes.hpp"
#include "step/boundary/symmetry_planes.hpp"

#include <vector>

namespace barreno {

/// The last that happens to the sums of every tile before they are added: symmetry planes
/// (mirror_sums), nodes shared with coarser cells (restrict_sums), then what other ranks hold.
/// Collective.
void sum_halos(const SymmetryPlanes& symmetry, const Grid& grid, std::vector<Nodes>& fields);

}  // namespace barreno
