// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/numbers.hpp"
#include "base/split_sizes.hpp"
#include "scene/scene.hpp"

#include <Kokkos_Macros.hpp>

#include <algorithm>
#include <cmath>

namespace barreno {

/// What a node may bring into the ledger, about: that of a full cell of the densest material which
/// goes through a cell in the step.
struct NodeSizes {
  SplitSizes energy, impulse;
};

inline NodeSizes node_sizes(const Scene& scene, double dt) {
  const GridSpec& grid = scene.grid;
  double volume = std::pow(grid.cell_size, dimensions(grid.mode));
  if (grid.mode == Mode::axisymmetric) volume *= two_pi * grid.upper[0];
  double density = 0.0;
  for (const MaterialSpec& spec : scene.materials)
    density = std::max(density, spec.material.density);
  const double mass = density * volume, speed = grid.cell_size / dt;
  return {SplitSizes(mass * speed * speed), SplitSizes(mass * speed)};
}

/// Adds a number of a node in two parts (RowSum): which tile counts a node depends on the tiles
/// that are active, and sums over a tile must not depend on that.
KOKKOS_INLINE_FUNCTION void add_split(double number, const SplitSizes& sizes, double (&sum)[2]) {
  const double rounded = (number + sizes.first) - sizes.first;
  sum[0] += rounded;
  sum[1] += ((number - rounded) + sizes.second) - sizes.second;
}

}  // namespace barreno
