// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

namespace barreno {

/// Planes of symmetry of the grid: at their nodes a cloud is half of one.
struct Mirrors {
  bool at_lower[3] = {}, at_upper[3] = {};
  int last[3] = {};  ///< index of the upper face

  Mirrors(const Scene& scene, const Grid& grid) {
    at_lower[0] = scene.grid.mode == Mode::axisymmetric && grid.lower[0] == 0.0;
    for (const ConditionSpec& condition : scene.conditions) {
      const auto face = static_cast<int>(condition.face);
      if (condition.kind != ConditionKind::symmetry) continue;
      (face % 2 == 0 ? at_lower : at_upper)[face / 2] = true;
    }
    for (int d = 0; d < 3; ++d) last[d] = grid.cells[d];
  }
  KOKKOS_INLINE_FUNCTION bool holds(int axis, int node) const {
    return (at_lower[axis] && node <= 0) || (at_upper[axis] && node >= last[axis]);
  }
};

}  // namespace barreno
