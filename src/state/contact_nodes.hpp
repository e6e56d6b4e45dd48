// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/patch.hpp"

#include <cstddef>
#include <vector>

namespace barreno {

/// Moments of a field's particles about a node, in cells: weight, first moments, second moments xx
/// xy (xz) yy (yz zz).
KOKKOS_INLINE_FUNCTION constexpr int moment_components(int dimensions) {
  return 1 + dimensions + dimensions * (dimensions + 1) / 2;
}
/// A pair's normal from its first field to its second, or zero, and the gap along it [cells].
KOKKOS_INLINE_FUNCTION constexpr int normal_components(int dimensions) {
  return dimensions + 1;
}
/// Directions that are compared at once (Directions): itself, some about it, the axes. Of each: how
/// far the first field reaches from the node, and where the second begins [cells].
KOKKOS_INLINE_FUNCTION constexpr int directions_about(int dimensions) {
  return dimensions == 2 ? 11 : 20;
}
/// Contact's change of v, its impulse over the step, and the part of that along the surfaces.
KOKKOS_INLINE_FUNCTION constexpr int impulse_components(int dimensions) {
  return 3 * dimensions;
}

/// Where the values of a tile begin, `components` per node.
KOKKOS_INLINE_FUNCTION std::size_t first_value(const Patch& patch, int tile, int components) {
  return static_cast<std::size_t>(tile) * static_cast<std::size_t>(patch.size * components);
}

/// Scratch of a step in which velocity fields may meet (docs/method.md 6), in patch layout. Values
/// are set in shared tiles only, and read at shared nodes only. Empty without contact.
struct ContactNodes {
  ArrayView<unsigned char> tile_fields;  ///< own tiles, then ghosts: bits of the fields in them
  ArrayView<unsigned char> shared_tile;  ///< own tiles: 1 if a node of the patch is shared
  /// own tiles, where cells have several sizes: 1 if a node stands for a shared one of a coarser
  /// tile
  ArrayView<unsigned char> passes_up;
  ArrayView<unsigned char>
      fields;  ///< own tiles: bits of the fields with mass at a shared node, else 0
  std::vector<ArrayView<double>> moments;  ///< by field; own tiles, then ghosts
  std::vector<ArrayView<double>> normal;   ///< by pair; own tiles
  std::vector<ArrayView<double>> reach;    ///< by pair; own tiles, then ghosts
};

}  // namespace barreno
