// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/dormancy.hpp"
#include "state/nodes.hpp"

#include <cmath>
#include <limits>

namespace barreno {

/// Which tiles solve_velocity need not solve: at rest, with the sums of the step before in them and
/// around them, and so slow then that they are still now. Whether one is passed over changes no bit
/// of the answer: what nodes of a still tile have of energy is dropped (docs/method.md 9).
struct RestingNodes {
  Dormancy dormancy;
  ArrayView<unsigned char> kept;
  ArrayView<int> neighbours;
  Patch patch;
  int active;
  double dt;
  double limit;  ///< of velocities of nodes that are still

  RestingNodes(const Grid& grid, const Dormancy& what, const Nodes& nodes, double step)
      : dormancy(what),
        kept(nodes.kept),
        neighbours(grid.neighbours),
        patch(grid.patch),
        active(grid.active),
        dt(step),
        limit(what.motion * grid.cell_size / step) {}

  KOKKOS_INLINE_FUNCTION bool watches(int tile) const {
    return dormancy.on && dormancy.rests(tile) != 0;
  }

  /// Sums of other ranks may have changed.
  KOKKOS_INLINE_FUNCTION bool have_kept_sums(int tile) const {
    for (int k = 0; k < patch.neighbours; ++k) {
      const int other = neighbours(tile * patch.neighbours + k);
      if (other >= active || (other >= 0 && kept(other) == 0)) return false;
    }
    return true;
  }

  /// v^n is that of the step that found the bounds, and v' - v grows with dt as f / m at most: an
  /// impedance lets it grow less, and a shorter step only lets it shrink. Bounds come of sums and
  /// quotients: a few round-offs more than they are.
  KOKKOS_INLINE_FUNCTION bool stays_still(int tile) const {
    if (!watches(tile) || kept(tile) == 0) return false;
    const double most = dormancy.speed(tile) + dt * dormancy.acceleration(tile);
    return most * (1.0 + 1e-12) <= limit && have_kept_sums(tile);
  }

  /// Keeps bounds of a tile that was solved, and whether it is still.
  /// @param motion      v' and v' - v of its nodes
  /// @param prescribed  a condition acts on one of them: its impulse counts, and may change
  /// @return that it is still and all that it has of energy may be dropped
  KOKKOS_INLINE_FUNCTION bool enter(int tile, const double* motion, bool prescribed) const {
    if (!watches(tile)) return false;
    const int dimensions = patch.dimensions;
    const int width = motion_components(dimensions);
    double speed = 0.0;
    double change = 0.0;
    bool numbers = true;
    for (int node = 0; node < patch.size; ++node)
      for (int d = 0; d < dimensions; ++d) {
        const double v = std::abs(motion[node * width + d]);
        const double dv = std::abs(motion[node * width + dimensions + d]);
        numbers = numbers && v <= std::numeric_limits<double>::max() &&
                  dv <= std::numeric_limits<double>::max();
        speed = v > speed ? v : speed;
        change = dv > change ? dv : change;
      }
    const bool still = numbers && speed <= limit && change <= limit;
    dormancy.still(tile) = still ? 1 : 0;
    const bool bounded = numbers && !prescribed;
    dormancy.speed(tile) = bounded ? speed + change : std::numeric_limits<double>::infinity();
    dormancy.acceleration(tile) = bounded ? change / dt : 0.0;
    return still && !prescribed;
  }
};

}  // namespace barreno
