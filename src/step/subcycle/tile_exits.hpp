// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/subcycling.hpp"

namespace barreno {

/// What is found of a tile and the ranks tell each other (Subcycling::reach): its period, the
/// directions, as bits, in which particles may leave it before the step is over (plan_subcycles),
/// and whether it holds particles in the step (find_node_periods).
constexpr int told_of_tile = 3;
enum { told_period, told_exits, told_holds };

/// Number of the direction to a tile of the 3^d around one, and of the one that leads back.
KOKKOS_INLINE_FUNCTION int direction(int x, int y, int z) {
  return (z + 1) * 9 + (y + 1) * 3 + x + 1;
}
constexpr int directions = 27;
KOKKOS_INLINE_FUNCTION int back(int towards) {
  return directions - 1 - towards;
}

/// Directions in which particles may leave a tile, a bit each.
KOKKOS_INLINE_FUNCTION unsigned exits_of_tile(const ArrayView<double>& reach, int tile) {
  return static_cast<unsigned>(reach(tile * told_of_tile + told_exits));
}
/// Whether it is foreseen that particles leave a tile for one so many tiles away.
KOKKOS_INLINE_FUNCTION bool is_foreseen(
    const Subcycling& subcycling, int tile, const int (&away)[3]
) {
  for (const int tiles : away)
    if (tiles < -1 || tiles > 1) return false;
  return (exits_of_tile(subcycling.reach, tile) >> direction(away[0], away[1], away[2]) & 1U) != 0;
}

}  // namespace barreno
