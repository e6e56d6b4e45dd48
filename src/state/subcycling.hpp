// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <cstddef>

namespace barreno {

/// Steps of several lengths. A step of the run is taken in 2^k parts, all of one length; the
/// particles of a tile take 1, 2, 4, ... parts at once, as their stable step allows. So do nodes
/// around which all tiles do (find_node_periods); other nodes move in each part. Between steps of
/// the run all tiles are at one time, so that nothing here outlives one. Arrays by own tile where
/// nothing else is said. docs/method.md 12
struct Subcycling {
  int most = 1;             ///< parts of a step at most, a power of two; 1: all tiles take one step
  int parts = 1;            ///< of the step that is taken
  int part = 0;             ///< which of them is taken now
  double length = 0.0;      ///< of a part; the last one of a step may be shorter [time]
  bool ends_all = false;    ///< all tiles end their steps with this part
  bool catches_up = false;  ///< this part is taken by the nodes that it has left out so far
  bool strays = false;      ///< particles must come to other tiles before the next part
  ArrayView<int> period;    ///< parts of a tile's own step; also of ghosts
  ArrayView<unsigned char> node_period;   ///< by own tile and slot: parts that a node takes at once
  ArrayView<unsigned char> node_periods;  ///< those of all nodes of a tile, a bit each
  ArrayView<unsigned char> ends;          ///< its particles take their step with this part
  ArrayView<unsigned char> solved;  ///< its nodes were asked for in this part (solve_velocity)
  ArrayView<unsigned char> gained;  ///< `gain` holds parts of its step that are over
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
  /// Of a step of so many parts, before this part [time].
  KOKKOS_INLINE_FUNCTION double elapsed_of(int parts_at_once) const {
    return (part % parts_at_once) * length;
  }
  KOKKOS_INLINE_FUNCTION double elapsed(int tile) const { return elapsed_of(period(tile)); }

  /// Whether nodes that take so many parts at once are solved in this one.
  KOKKOS_INLINE_FUNCTION bool solves(int parts_at_once) const {
    const bool over = (part + 1) % parts_at_once == 0;
    return catches_up ? !over : ends_all || over;
  }
  /// Which periods the nodes of a tile have that are solved in this part, as bits.
  KOKKOS_INLINE_FUNCTION int solved_periods(int tile) const {
    if (!on()) return 1;
    int out = 0;
    for (int bit = 1; bit <= parts; bit *= 2)
      if ((node_periods(tile) & bit) != 0 && solves(bit)) out |= bit;
    return out;
  }
  /// Whether all nodes of a tile are solved once in its step.
  KOKKOS_INLINE_FUNCTION bool is_steady(int tile) const {
    return node_periods(tile) == period(tile);
  }
  /// Whether `whole` has the motion of the nodes over the step that a tile ends, not Nodes::motion.
  KOKKOS_INLINE_FUNCTION bool takes_whole(int tile) const {
    return on() && elapsed(tile) > 0.0 && !is_steady(tile);
  }
};

/// Whether some tiles are within their own steps.
inline bool goes_on(const Subcycling& subcycling) {
  return !subcycling.ends_all && subcycling.part + 1 < subcycling.parts;
}

}  // namespace barreno
