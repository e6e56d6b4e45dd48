// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <cstddef>

namespace barreno {

/// Steps of several lengths. A step of the run is taken in 2^k parts, all of one length, and in
/// each of them all nodes move; the particles of a tile take 1, 2, 4, ... parts at once, as their
/// stable step allows. Between steps of the run all tiles are at one time, so that nothing here
/// outlives one. Arrays by own tile where nothing else is said. docs/method.md 12
struct Subcycling {
  int most = 1;           ///< parts of a step at most, a power of two; 1: all tiles take one step
  int parts = 1;          ///< of the step that is taken
  int part = 0;           ///< which of them is taken now
  bool ends_all = false;  ///< all tiles end their steps with this part
  bool strays = false;    ///< particles must come to other tiles before the next part
  ArrayView<int> period;  ///< parts of a tile's own step; also of ghosts
  ArrayView<unsigned char> ends;    ///< its particles take their step with this part
  ArrayView<unsigned char> solved;  ///< its nodes were asked for in this part (solve_velocity)
  ArrayView<unsigned char> gained;  ///< `gain` holds parts of its step that are over
  ArrayView<double> elapsed;        ///< of its own step before this part [time]
  ArrayView<double> gain;   ///< in the layout of Nodes::motion: displacement, change of velocity
  ArrayView<double> whole;  ///< the same of a whole step: mean velocity, change of velocity
  ArrayView<double> reach;  ///< what plan_subcycles tells of tiles (tile_exits.hpp), also of ghosts
  ArrayView<int> entrants;  ///< scratch of plan_subcycles
  long activation = -1;     ///< Grid::activations that all this belongs to

  KOKKOS_INLINE_FUNCTION bool on() const { return parts > 1; }
  KOKKOS_INLINE_FUNCTION bool starts(int tile) const {
    return parts == 1 || part % period(tile) == 0;
  }
  KOKKOS_INLINE_FUNCTION bool is_over(int tile) const {
    return ends_all || (part + 1) % period(tile) == 0;
  }
};

/// Whether some tiles are within their own steps.
inline bool goes_on(const Subcycling& subcycling) {
  return !subcycling.ends_all && subcycling.part + 1 < subcycling.parts;
}

}  // namespace barreno
