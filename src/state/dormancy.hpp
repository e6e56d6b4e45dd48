// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <limits>

namespace barreno {

/// Why a step leaves a tile's particles as they are.
enum Stay : unsigned char { moves, is_dormant_tile, is_in_its_step };

/// Dormant tiles, whose particles a step leaves as they are; all others are awake. Which tiles are
/// dormant follows from the particles and the motion of the nodes anew in every step, so that it is
/// the same on any ranks. Arrays by own tile. docs/method.md 9
struct Dormancy {
  bool on = false;      ///< without it nothing here is used
  bool skip = false;    ///< without it dormant particles are updated too, with no motion
  double motion = 0.0;  ///< what a node may move by in a step without waking a tile [cells]
  ArrayView<unsigned char> candidate;   ///< its particles have no velocity (9.1)
  ArrayView<unsigned char> motionless;  ///< none of its nodes moves, of candidates (9.2)
  ArrayView<unsigned char> unsolved;    ///< their nodes are left as the last step solved them
  ArrayView<unsigned char> dormant;     ///< candidate and motionless
  ArrayView<unsigned char> stays;       ///< of Stay: its particles are left as they are
  ArrayView<int> rows;                  ///< its particles
  ArrayView<int>
      summed_rows;  ///< particles that its sums of the last step belong to; 0: sum afresh
  ArrayView<double> speed, acceleration;  ///< of their nodes, at most; speed infinite if unknown
  ArrayView<double> step;  ///< stable step of the particles that `summed_rows` counts
  /// The least of those of tiles that are skipped.
  double stable_step = std::numeric_limits<double>::infinity();
  long activation = -1;  ///< Grid::activations that all this belongs to
  int skipped_rows = 0;  ///< particles that the last step skipped on this rank

  KOKKOS_INLINE_FUNCTION bool is_dormant(int tile) const { return on && dormant(tile) != 0; }
  /// Dormant, or within its own step (Subcycling).
  KOKKOS_INLINE_FUNCTION bool is_left(int tile) const { return on && stays(tile) != moves; }
};

}  // namespace barreno
