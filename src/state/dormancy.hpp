// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <limits>

namespace barreno {

/// Tiles whose particles a step leaves as they are. It follows from the particles and the motion of
/// the nodes anew in every step, so that it is the same on any ranks; by own tile.
struct Dormancy {
  bool on = false;      ///< without it nothing here is used
  bool skips = false;   ///< without it dormant particles are updated too, with no motion
  double motion = 0.0;  ///< what a node may move by in a step without waking a tile [cells]
  ArrayView<unsigned char> rests;    ///< its particles have no velocity
  ArrayView<unsigned char> dormant;  ///< and none of its nodes moves
  ArrayView<int> rows;  ///< particles that its sums of the last step belong to; 0: sum afresh
  ArrayView<unsigned char> still;         ///< none of its nodes moves, of tiles that rest
  ArrayView<double> speed, acceleration;  ///< of their nodes, at most; speed infinite if unknown
  ArrayView<double> step;                 ///< stable step of the particles that `rows` counts
  /// The least of those of tiles that are left out.
  double stable_step = std::numeric_limits<double>::infinity();
  long activation = -1;  ///< Grid::activations that all this belongs to
  int skipped = 0;       ///< particles that the last step left out on this rank

  /// Whether the particles of a tile stay as they are.
  KOKKOS_INLINE_FUNCTION bool leaves(int tile) const { return on && dormant(tile) != 0; }
};

}  // namespace barreno
