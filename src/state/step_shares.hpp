// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/grid_section.hpp"

#include <Kokkos_Macros.hpp>

#include <vector>

namespace barreno {

/// Numbers of parts that a tile's own step may have, 1, 2, 4, 8, 16 (Step/Subcycles).
constexpr int step_lengths = 5;

/// How particle-steps distribute over cell sizes and over lengths of step; zero on a grid of equal
/// cells with one step for all, where there is nothing to tell.
struct StepShares {
  double of_level[max_level + 1] = {};  ///< particles in cells of Grid/Cell Size / 2^l [-]
  double of_length[step_lengths] = {};  ///< in steps of 2^k parts [-]
};
KOKKOS_INLINE_FUNCTION void add(const StepShares& from, StepShares& to) {
  for (int l = 0; l <= max_level; ++l) to.of_level[l] += from.of_level[l];
  for (int k = 0; k < step_lengths; ++k) to.of_length[k] += from.of_length[k];
}

/// All of them in one list, as checkpoints and sums over ranks have them, and back.
std::vector<double> values_of(const StepShares& shares);
StepShares shares_of(const std::vector<double>& values);

}  // namespace barreno
