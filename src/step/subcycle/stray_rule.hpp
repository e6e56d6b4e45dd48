// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/gimp.hpp"
#include "state/particles.hpp"

#include <cmath>

namespace barreno {

/// How far a particle may be beyond the cells of its tile and still reach no node beyond the tile's
/// patch: with GIMP, whose box covers three nodes from the one below its lower face on, half of its
/// size. Within a step of several parts such a particle keeps its tile. docs/method.md 12
struct StrayRule {
  int dimensions, tile_cells;
  double lower[3];
  FieldView position, half_size;
  bool tolerates;  ///< for other shape functions there is no room

  StrayRule(const Grid& grid, const Particles& particles)
      : dimensions(grid.patch.dimensions),
        tile_cells(grid.patch.tile_cells),
        lower{grid.lower[0], grid.lower[1], grid.lower[2]},
        position(particles.position.values),
        half_size(particles.half_size.values),
        tolerates(grid.shape == Gimp::word) {}

  /// Cells from a tile's lower face to a particle.
  KOKKOS_INLINE_FUNCTION double cells_along(int d, int p, const TileFrame& of) const {
    return (position(p, d) - lower[d]) / of.cell_size - of.position[d] * tile_cells;
  }
  /// So many tiles before or behind it are the cells that hold a particle at `cells`.
  KOKKOS_INLINE_FUNCTION int tiles_away(double cells) const {
    return static_cast<int>(std::floor(cells / tile_cells));
  }
  /// On which side a particle at `cells` is too far from the tile: 1, -1 or, if on none, 0.
  KOKKOS_INLINE_FUNCTION int side_of(double cells, int d, int p, const TileFrame& of) const {
    constexpr double within_half_size = 0.9;
    constexpr double widest = 0.5;  // of a box in cells, where particles come from larger ones too
    const double half = half_size(p, d) / of.cell_size;
    const double margin = tolerates ? within_half_size * (half < widest ? half : widest) : 0.0;
    return cells >= tile_cells + margin ? 1 : cells < -margin ? -1 : 0;
  }
  KOKKOS_INLINE_FUNCTION bool is_stray(int p, const TileFrame& of) const {
    bool stray = false;
    for (int d = 0; d < dimensions; ++d)
      stray = stray || side_of(cells_along(d, p, of), d, p, of) != 0;
    return stray;
  }
};

}  // namespace barreno
