// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/ledger.hpp"
#include "state/particles.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

/// Why a row is to be taken out, for kernels: the box that particles may occupy, their motion and
/// what the step has found wrong with them.
struct RemovalRule {
  int dimensions;
  double lower[3], upper[3];
  FieldView position, velocity;
  ArrayView<Fault> fault;

  RemovalRule(const Grid& grid, const Particles& particles)
      : dimensions(std::min(grid.patch.dimensions, 3)),  // the bound of lower and upper
        lower{grid.lower[0], grid.lower[1], grid.lower[2]},
        upper{grid.upper[0], grid.upper[1], grid.upper[2]},
        position(particles.position.values),
        velocity(particles.velocity.values),
        fault(particles.fault) {}

  KOKKOS_INLINE_FUNCTION bool is_finite(int p) const {
    double sum = 0.0;  // one that is not finite makes it so
    for (int d = 0; d < dimensions; ++d) sum += position(p, d);
    for (int d = 0; d < dimensions; ++d) sum += velocity(p, d);
    return std::isfinite(sum);
  }
  KOKKOS_INLINE_FUNCTION bool is_inside(int p) const {
    bool inside = true;
    for (int d = 0; d < dimensions; ++d)
      inside = inside && position(p, d) >= lower[d] && position(p, d) < upper[d];
    return inside;
  }
  /// It has failed or left the grid: it comes nowhere.
  KOKKOS_INLINE_FUNCTION bool is_lost(int p) const {
    return fault(p) != Fault::none || !is_inside(p);
  }
  /// A RemovalCause; -1: it stays.
  KOKKOS_INLINE_FUNCTION int cause_of(int p) const {
    if (!is_finite(p)) return static_cast<int>(RemovalCause::not_finite);
    switch (fault(p)) {
      case Fault::failed:
        return static_cast<int>(RemovalCause::material_failure);
      case Fault::expanded:
        return static_cast<int>(RemovalCause::expanded);
      case Fault::inverted:
        return static_cast<int>(RemovalCause::inverted);
      case Fault::none:
        break;
    }
    return is_inside(p) ? -1 : static_cast<int>(RemovalCause::left_grid);
  }
};

/// The fault of a particle that is to be taken out for this cause; none for causes that its place
/// and velocity tell.
Fault fault_of_cause(int cause);

/// Take out the rows that have a cause and tally them by it, but for those of a rigid body.
void remove_lost(const Grid& grid, Particles& particles, OwnLedger& ledger);

}  // namespace barreno
