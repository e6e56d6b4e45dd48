// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// What a step of the method cannot do without, per particle.
///
/// Bytes: the grid's part of a step needs all particles, so state passes through memory twice: to
/// the grid (read), from it (read, and what the step changes written). A node's sums and motion are
/// written and read once each, shared by the particles of its cell.
///
/// Operations: a multiplication and an addition for each number that a node takes or gives: mass,
/// momentum and force to it; velocity, increment and velocity gradient from it. Those of the
/// weights and of the material are left out.
struct LeastWork {
  double bytes = 0.0;
  double operations = 0.0;
  double nodes = 0.0;  ///< of one particle's support, mean over the scene

  /// Shortest time on a machine with that bandwidth and arithmetic [s].
  double seconds(double bytes_per_second, double operations_per_second) const;
};

/// Of the first material's particles.
LeastWork least_work(const Scene& scene, const State& state);

/// Most multiplications and additions that this process was seen to do, in vectors that stay in
/// registers [1/s].
double measure_arithmetic();

}  // namespace barreno
