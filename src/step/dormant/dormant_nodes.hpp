// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/dormancy.hpp"
#include "state/nodes.hpp"
#include "state/subcycling.hpp"

#include <cmath>
#include <limits>

namespace barreno {

/// Which tiles solve_velocity need not solve (find_unsolved_tiles): candidates with the sums of the
/// step before in them and around them, and so slow then that they are motionless now. Whether one
/// is skipped changes no bit of the answer: what nodes of a motionless tile have of energy is
/// dropped (docs/method.md 9).
///
/// With several velocity fields a tile's nodes are motionless if those of all fields are.
struct DormantNodes {
  Dormancy dormancy;
  bool first_field;  ///< the first of the step that is solved
  ArrayView<unsigned char> sums_kept;
  ArrayView<TileFrame> frame;
  ArrayView<int> neighbours, parent;
  Patch patch;
  int active;
  Subcycling subcycling;

  DormantNodes(
      const Grid& grid,
      const Dormancy& what,
      bool is_first_field,
      const Subcycling& parts,
      const Nodes& nodes
  )
      : dormancy(what),
        first_field(is_first_field),
        sums_kept(nodes.sums_kept),
        frame(grid.tile_frame),
        neighbours(grid.neighbours),
        parent(grid.parent),
        patch(grid.patch),
        active(grid.active),
        subcycling(parts) {}

  KOKKOS_INLINE_FUNCTION bool is_candidate(int tile) const {
    return dormancy.on && dormancy.candidate(tile) != 0;
  }

  /// Of velocities of motionless nodes [length/time].
  KOKKOS_INLINE_FUNCTION double limit(int tile) const {
    return dormancy.motion * frame(tile).cell_size / frame(tile).dt;
  }
  /// Length of the steps of nodes that take so many parts of a step at once [time].
  KOKKOS_INLINE_FUNCTION double step_of(int tile, int period) const {
    return subcycling.elapsed_of(period) + frame(tile).part;
  }

  /// Of its neighbours. Sums of other ranks may have changed.
  KOKKOS_INLINE_FUNCTION bool all_around_keep_sums(int tile) const {
    for (int k = 0; k < patch.neighbours; ++k) {
      const int other = neighbours(tile * patch.neighbours + k);
      if (other >= active || (other >= 0 && sums_kept(other) != sums_as_were)) return false;
    }
    return true;
  }

  /// v^n is that of the step that found the bounds, and v' - v grows with dt as f / m at most: an
  /// impedance lets it grow less, and a shorter step only lets it shrink. Bounds come of sums and
  /// quotients: a few round-offs more than they are.
  KOKKOS_INLINE_FUNCTION bool stays_motionless(int tile) const {
    if (!is_candidate(tile) || sums_kept(tile) != sums_as_were) return false;
    const double most = dormancy.speed(tile) + frame(tile).dt * dormancy.acceleration(tile);
    if (most * (1.0 + 1e-12) > limit(tile)) return false;
    // Nodes that are taken from the coarser lattice move by the sums around the tile there.
    for (int t = tile; t >= 0; t = parent.extent(0) > 0 ? parent(t) : -1)
      if (!all_around_keep_sums(t)) return false;
    return true;
  }

  /// What find_unsolved_tiles found before the first field was solved.
  KOKKOS_INLINE_FUNCTION bool leaves_unsolved(int tile) const {
    return dormancy.on && dormancy.unsolved(tile) != 0;
  }

  /// What nodes that were solved do at most.
  struct Bounds {
    double speed = 0.0, change = 0.0, acceleration = 0.0;
    bool numbers = true, motionless = true;
  };
  /// @param period  parts of a step that these nodes take at once
  KOKKOS_INLINE_FUNCTION void look_at_nodes(int tile, const double* motion, int period, Bounds& all)
      const {
    const int dimensions = patch.dimensions;
    const int width = motion_components(dimensions);
    const bool some = subcycling.on() && subcycling.node_periods(tile) != period;
    double speed = 0.0;
    double change = 0.0;
    for (int node = 0; node < patch.size; ++node) {
      if (some && subcycling.node_period(tile * patch.size + node) != period) continue;
      for (int d = 0; d < dimensions; ++d) {
        const double v = std::abs(motion[node * width + d]);
        const double dv = std::abs(motion[node * width + dimensions + d]);
        all.numbers = all.numbers && v <= std::numeric_limits<double>::max() &&
                      dv <= std::numeric_limits<double>::max();
        speed = v > speed ? v : speed;
        change = dv > change ? dv : change;
      }
    }
    const double step = step_of(tile, period);
    const double share = step / frame(tile).dt;
    all.motionless = all.motionless && speed <= limit(tile) && change <= share * limit(tile);
    all.speed = speed > all.speed ? speed : all.speed;
    all.change = change > all.change ? change : all.change;
    all.acceleration = change / step > all.acceleration ? change / step : all.acceleration;
  }

  /// Notes the bounds of a tile that was solved, and whether it is motionless.
  /// @param motion      v' and v' - v of its nodes
  /// @param prescribed  a condition gives work or axial momentum at one of them, or contact acts:
  ///                    its impulse counts, and may change
  /// @param periods     of the nodes that were solved now (Subcycling::solved_periods)
  /// @return that it is motionless and all that it has of energy may be dropped
  KOKKOS_INLINE_FUNCTION bool enter(
      int tile, const double* motion, bool prescribed, int periods = 1
  ) const {
    if (!is_candidate(tile)) return false;
    Bounds all;
    for (int period = 1; period <= periods; period *= 2)
      if ((periods & period) != 0) look_at_nodes(tile, motion, period, all);
    const bool motionless = all.numbers && all.motionless;
    const bool first = first_field && subcycling.starts(tile) && !subcycling.catches_up;
    dormancy.motionless(tile) = motionless && (first || dormancy.motionless(tile) != 0) ? 1 : 0;
    const bool some = subcycling.on() && subcycling.node_periods(tile) != periods;
    const bool bounded = all.numbers && !prescribed && !some;
    const double most = bounded ? all.speed + all.change : std::numeric_limits<double>::infinity();
    const double gain = bounded ? all.acceleration : 0.0;
    const bool larger = first_field || most > dormancy.speed(tile);
    if (larger) dormancy.speed(tile) = most;
    if (first_field || gain > dormancy.acceleration(tile)) dormancy.acceleration(tile) = gain;
    return motionless && !prescribed;
  }

  /// Sums may have changed since the bounds were found, and the nodes wait for the end of the step.
  KOKKOS_INLINE_FUNCTION void forget_bounds(int tile) const {
    if (is_candidate(tile)) dormancy.speed(tile) = std::numeric_limits<double>::infinity();
  }
};

}  // namespace barreno
