// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"

#include <vector>

namespace barreno {

/// How many particles of all sets every own tile has.
/// @param rows  by own tile; what is in it is overwritten
void count_rows(const Grid& grid, const std::vector<Particles>& sets, const ArrayView<int>& rows);

}  // namespace barreno
