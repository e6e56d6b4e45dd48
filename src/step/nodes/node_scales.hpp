// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/numbers.hpp"
#include "base/split_scales.hpp"
#include "scene/scene.hpp"

#include <Kokkos_Macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace barreno {

/// What a node may bring into the ledger, about: that of a full cell of the densest material which
/// goes through a cell in the step.
struct NodeScales {
  SplitScales energy, impulse;
};

/// These scales for the nodes of a tile; captured by value in kernels.
struct NodeScaleRule {
  int dimensions;
  double depth = 1.0;    ///< of a cell across the plane: around the axis in axisymmetry
  double density = 0.0;  ///< of the densest material [mass/length^3]

  NodeScaleRule(const std::vector<MaterialSpec>& materials, const GridSpec& grid)
      : dimensions(barreno::dimensions(grid.mode)) {
    if (grid.mode == Mode::axisymmetric) depth = two_pi * grid.upper[0];
    for (const MaterialSpec& spec : materials) density = std::max(density, spec.density());
  }

  KOKKOS_INLINE_FUNCTION NodeScales operator()(double cell_size, double dt) const {
    const double volume = std::pow(cell_size, dimensions) * depth;
    const double mass = density * volume, speed = cell_size / dt;
    return {SplitScales(mass * speed * speed), SplitScales(mass * speed)};
  }
};

/// Adds a number of a node in two parts (RowSum): which tile counts a node depends on the tiles
/// that are active, and sums over a tile must not depend on that.
KOKKOS_INLINE_FUNCTION void add_split(double number, const SplitScales& scales, double (&sum)[2]) {
  const double rounded = (number + scales.first) - scales.first;
  sum[0] += rounded;
  sum[1] += ((number - rounded) + scales.second) - scales.second;
}

}  // namespace barreno
