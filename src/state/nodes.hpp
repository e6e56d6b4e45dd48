// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/patch.hpp"

#include <cstddef>

namespace barreno {

/// Nodal quantities in patch layout: value(tile, slot, component).
///
/// One node is one cache line of sums: mass, momentum and force (in two dimensions with three spare
/// components), so that a projection is a vector operation per node.
inline constexpr int sum_components = 8;
/// The last component: impedance of non-reflecting faces [mass/time].
inline constexpr int impedance_component = sum_components - 1;
KOKKOS_INLINE_FUNCTION constexpr int first_force(int dimensions) {
  return 1 + dimensions;
}
/// Velocity after the step and its increment over the step; padded in three dimensions.
KOKKOS_INLINE_FUNCTION constexpr int motion_components(int dimensions) {
  return dimensions == 3 ? 8 : 4;
}

/// Where the values of a tile begin.
KOKKOS_INLINE_FUNCTION std::size_t first_sum(const Patch& patch, int tile) {
  return static_cast<std::size_t>(tile) * static_cast<std::size_t>(patch.size * sum_components);
}
KOKKOS_INLINE_FUNCTION std::size_t first_motion(const Patch& patch, int tile) {
  return static_cast<std::size_t>(tile) *
         static_cast<std::size_t>(patch.size * motion_components(patch.dimensions));
}

/// Whether a tile's particles give their sums anew.
enum SumsKept : unsigned char {
  sums_afresh,   ///< they do
  sums_as_were,  ///< those of the step before still hold
  sums_gaining   ///< its step goes on (Subcycling): momenta follow the motion of the nodes
};

/// Of one velocity field (scene/velocity_fields.hpp).
struct Nodes {
  ArrayView<double>
      sums;  ///< own tiles, then ghosts; partial until solve_velocity adds the overlaps
  ArrayView<unsigned char> sums_kept;  ///< by own tile, of SumsKept; empty: none keeps them
  ArrayView<double> motion;            ///< own tiles only
  ArrayView<double> tally;             ///< energy and impulse of each tile over the step, scratch
  ArrayView<double> mirrored;  ///< by own tile: momentum and force along y that its particles gave
                               ///< to nodes behind symmetry planes across y; empty without such
  ArrayView<double> impulse;   ///< of contact, in shared tiles (ContactNodes); empty without it

  KOKKOS_INLINE_FUNCTION bool keeps_sums(int tile) const {
    return sums_kept.extent(0) > 0 && sums_kept(tile) != sums_afresh;
  }
};

}  // namespace barreno
