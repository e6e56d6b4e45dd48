// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

#include <vector>

namespace barreno {

/// A plane of symmetry that a deck asks for: a face of the grid. prescribe_velocities stops the
/// nodes on it, mirror_nodes gives what is behind it to the images.
struct SymmetryPlane {
  int axis = 0;  ///< that it lies across
  int node = 0;  ///< of the box at level 0, along that axis
  bool lower = true;

  /// @param index  of a node on the lattice of a level
  KOKKOS_INLINE_FUNCTION bool is_behind(int index, int level) const {
    return lower ? index < node << level : index > node << level;
  }
};

/// Planes of symmetry of the grid, as kernels read them; the axis of revolution is one where
/// clouds of particles are looked at, since a cloud at it is half of one.
struct SymmetryPlanes {
  int count = 0;
  /// Those across y last: they leave masses where the others would look for impedances.
  SymmetryPlane list[6];
  bool any_axial = false;  ///< one lies across y
  bool at_lower[3] = {}, at_upper[3] = {};
  int last[3] = {};  ///< index of the upper face

  SymmetryPlanes(const std::vector<ConditionSpec>& conditions, const Grid& grid) {
    at_lower[0] = grid.mode == Mode::axisymmetric && grid.lower[0] == 0.0;
    for (int d = 0; d < 3; ++d) last[d] = grid.cells[d];
    for (const bool across_y : {false, true})
      for (const ConditionSpec& condition : conditions) {
        const auto face = static_cast<int>(condition.face);
        const int axis = face / 2;
        if (condition.kind != ConditionKind::symmetry || (axis == 1) != across_y) continue;
        const bool lower = face % 2 == 0;
        list[count++] = {axis, lower ? 0 : grid.cells[axis], lower};
        (lower ? at_lower : at_upper)[axis] = true;
        any_axial = any_axial || across_y;
      }
  }

  /// Whether a node lies on or behind one across an axis.
  /// @param at     position of a tile
  /// @param place  of the node in the tile's patch, along the axis
  KOKKOS_INLINE_FUNCTION bool holds(int axis, const Patch& patch, const TilePosition& at, int place)
      const {
    const int node = at[axis] * patch.tile_cells - patch.reach + place;
    return (at_lower[axis] && node <= 0) || (at_upper[axis] && node >= last[axis] << at.level);
  }

  /// Whether the patch of a tile reaches behind a plane.
  KOKKOS_INLINE_FUNCTION static bool reaches(
      const SymmetryPlane& plane, const Patch& patch, const TilePosition& position
  ) {
    const int first = position[plane.axis] * patch.tile_cells - patch.reach;
    return plane.is_behind(plane.lower ? first : first + patch.nodes - 1, position.level);
  }
  /// visit(slot behind the plane, slot of its image) of a tile's patch.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION static void for_each_image(
      const SymmetryPlane& plane, const Patch& patch, const TilePosition& position, Visitor&& visit
  ) {
    if (!reaches(plane, patch, position)) return;
    const int first = position[plane.axis] * patch.tile_cells - patch.reach;
    const int on_plane = (plane.node << position.level) - first;  // place along the axis
    const int last = patch.nodes - 1;
    const int farthest = 2 * on_plane;  // the image of place 0
    const int begin = plane.lower ? (farthest > last ? farthest - last : 0) : on_plane + 1;
    const int end = plane.lower ? on_plane : (farthest < last ? farthest + 1 : patch.nodes);
    int stride = 1;
    for (int axis = 0; axis < plane.axis; ++axis) stride *= patch.nodes;
    for (int block = 0; block < patch.size; block += stride * patch.nodes)
      for (int i = begin; i < end; ++i)
        for (int slot = block + i * stride; slot < block + (i + 1) * stride; ++slot)
          visit(slot, slot + (farthest - 2 * i) * stride);
  }
};

}  // namespace barreno
