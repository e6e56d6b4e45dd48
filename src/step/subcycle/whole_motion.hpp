// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/nodes.hpp"
#include "state/subcycling.hpp"

namespace barreno {

/// What moves a node over the step that a tile ends: the mean velocity, which makes the path of
/// one step of that length, and the sum of the changes. docs/method.md (12.2)
struct WholeMotion {
  Patch patch;
  ArrayView<TileFrame> frame;
  ArrayView<double> motion;
  Subcycling subcycling;

  /// Parts that a node takes at once.
  KOKKOS_INLINE_FUNCTION int period_of(int tile, int slot) const {
    return subcycling.on() ? subcycling.node_period(tile * patch.size + slot) : 1;
  }
  /// Length of the steps of nodes that take so many parts at once, with the present part [time].
  KOKKOS_INLINE_FUNCTION double step_of(int tile, int period) const {
    return subcycling.elapsed_of(period) + frame(tile).part;
  }

  /// @param out  in the layout of Nodes::motion, its last components 0
  KOKKOS_INLINE_FUNCTION void find(int tile, int slot, double* out) const {
    const int dimensions = patch.dimensions;
    const int width = motion_components(dimensions);
    const std::size_t at = first_motion(patch, tile) + static_cast<std::size_t>(slot * width);
    const double* const last = &motion(at);
    for (int i = 0; i < width; ++i) out[i] = last[i];
    if (!subcycling.on() || period_of(tile, slot) >= subcycling.period(tile)) return;
    const double whole_step = step_of(tile, subcycling.period(tile));
    const double last_step = step_of(tile, period_of(tile, slot));
    const double lead = 0.5 * (whole_step - last_step);
    if (lead == 0.0) return;
    const double* const before = &subcycling.gain(at);
    const bool gained = subcycling.gained(tile) != 0;
    const bool moved = subcycling.solved(tile) != 0;  // what is not solved is motionless
    for (int d = 0; d < dimensions; ++d) {
      const double path = (gained ? before[d] : 0.0) + (moved ? last_step * last[d] : 0.0);
      const double change =
          (gained ? before[dimensions + d] : 0.0) + (moved ? last[dimensions + d] : 0.0);
      out[d] = (path + lead * change) / whole_step;
      out[dimensions + d] = change;
    }
  }
};

}  // namespace barreno
