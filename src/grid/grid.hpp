// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "scene/scene.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <array>
#include <memory>
#include <vector>

namespace barreno {

/// Cells are stored in square tiles, and only tiles that hold particles exist. A tile's patch is
/// its own nodes and the ones that its particles can reach around it; neighbouring patches overlap.
/// Every tile sums its own particles in its own patch, then each patch adds the overlapping parts
/// of its neighbours in one fixed order: the sums do not depend on the rank count, the
/// decomposition or the order of particles, and one exchange per step serves both directions.
inline constexpr int tile_cells = 8;  ///< per direction
inline constexpr int reach = 1;       ///< nodes beyond the tile's own cells
inline constexpr int patch_nodes = tile_cells + 1 + 2 * reach;  ///< per direction
inline constexpr int patch_size = patch_nodes * patch_nodes;
inline constexpr int cells_per_tile = tile_cells * tile_cells;
inline constexpr int neighbour_count = 9;  ///< a tile and those around it, lexicographic

/// The communication plan between the ranks that share tiles (Tpetra); hidden to keep compile times
/// low.
struct HaloPlan;

struct Grid {
  Mode mode = Mode::axisymmetric;
  double lower[2] = {0.0, 0.0};
  double upper[2] = {0.0, 0.0};
  double cell_size = 0.0;
  int cells[2] = {0, 0};
  int tiles[2] = {0, 0};  ///< of the whole box, active or not

  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  std::vector<int> owner;  ///< rank of every tile of the box

  int active = 0;  ///< tiles that this rank owns and stores
  int ghosts = 0;  ///< tiles of other ranks whose patch overlaps one of ours, stored behind ours
  ArrayView<int> tile_x, tile_y;  ///< position of the active tiles in the box
  ArrayView<int> directory;       ///< tile of the box -> local tile, or -1
  ArrayView<int> neighbours;      ///< tile * 9 + k -> local tile (ghosts included), or -1
  ArrayView<unsigned char>
      counts;  ///< tile * patch_size + slot: 1 if this tile's copy of the node counts
  std::shared_ptr<HaloPlan> halo;

  int tile_id(int tx, int ty) const { return ty * tiles[0] + tx; }
  bool holds(double x, double y) const {
    return x >= lower[0] && x < upper[0] && y >= lower[1] && y < upper[1];
  }
};

/// A cell as its tile in the box and its place in the tile.
struct Cell {
  int tile = 0;
  int inside = 0;
};

/// @pre grid.holds(x, y)
inline Cell cell_of(const Grid& grid, double x, double y) {
  const double per_cell = 1.0 / grid.cell_size;
  const int cx = static_cast<int>((x - grid.lower[0]) * per_cell);
  const int cy = static_cast<int>((y - grid.lower[1]) * per_cell);
  return {
      grid.tile_id(cx / tile_cells, cy / tile_cells),
      cy % tile_cells * tile_cells + cx % tile_cells};
}

/// Rank that owns the tile around a point of the box.
inline int owner_of(const Grid& grid, double x, double y) {
  return grid.owner[static_cast<std::size_t>(cell_of(grid, x, y).tile)];
}

}  // namespace barreno
