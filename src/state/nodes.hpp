// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/patch.hpp"

#include <cstddef>

namespace barreno {

/// Nodal quantities in patch layout: value(tile, slot, component).
///
/// One node is one cache line of sums: mass, momentum x y, force x y (three spare components, which
/// the third dimension will fill), so that a projection is a vector operation per node.
inline constexpr int sum_components = 8;
/// Velocity x y after the step and its increment x y over the step.
inline constexpr int motion_components = 4;

/// Where the values of a tile begin.
KOKKOS_INLINE_FUNCTION std::size_t first_sum(const Patch& patch, int tile) {
  return static_cast<std::size_t>(tile) * static_cast<std::size_t>(patch.size * sum_components);
}
KOKKOS_INLINE_FUNCTION std::size_t first_motion(const Patch& patch, int tile) {
  return static_cast<std::size_t>(tile) * static_cast<std::size_t>(patch.size * motion_components);
}

struct Nodes {
  ArrayView<double>
      sums;  ///< own tiles, then ghosts; partial until solve_velocity adds the overlaps
  ArrayView<double> motion;  ///< own tiles only
  ArrayView<double> tally;   ///< energy and impulse of each tile over the step, scratch
};

}  // namespace barreno
