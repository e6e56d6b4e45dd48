// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/patch.hpp"
#include "scene/scene.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <array>
#include <memory>
#include <vector>

namespace barreno {

/// The communication plan between the ranks that share tiles (Tpetra); hidden to keep compile times
/// low.
struct HaloPlan;

/// Position of a tile in the box, in tiles along x, y, z.
struct TilePlace {
  int along[3] = {0, 0, 0};
  KOKKOS_INLINE_FUNCTION int operator[](int axis) const { return along[axis]; }
};

/// Cells are stored in square (3D: cubic) tiles, and only tiles that hold particles exist.
/// Neighbouring patches overlap. Every tile sums its own particles in its own patch, then each
/// patch adds the overlapping parts of its neighbours in one fixed order: the sums do not depend on
/// the rank count, the decomposition or the order of particles, and one exchange per step serves
/// both directions.
///
/// Two-dimensional modes have one cell and one tile along z.
struct Grid {
  Mode mode = Mode::axisymmetric;
  Patch patch;
  double lower[3] = {0.0, 0.0, 0.0};
  double upper[3] = {0.0, 0.0, 0.0};
  double cell_size = 0.0;
  int cells[3] = {0, 0, 1};
  int tiles[3] = {0, 0, 1};  ///< of the whole box, active or not

  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  std::vector<int> owner;  ///< rank of every tile of the box

  long activations = 0;  ///< times that the local tiles were numbered anew
  int active = 0;        ///< tiles that this rank owns and stores
  int ghosts = 0;  ///< tiles of other ranks whose patch overlaps one of ours, stored behind ours
  ArrayView<TilePlace> tile_place;  ///< of the active tiles and the ghosts
  ArrayView<int> directory;         ///< tile of the box -> local tile, or -1
  ArrayView<int>
      neighbours;  ///< tile * patch.neighbours + k -> local tile (ghosts included), or -1
  ArrayView<unsigned char>
      counts;  ///< tile * patch.size + slot: 1 if this tile's copy of the node counts
  std::shared_ptr<HaloPlan> halo;

  int tile_id(int x, int y, int z) const { return (z * tiles[1] + y) * tiles[0] + x; }
  TilePlace place_of_tile(int id) const {
    return {{id % tiles[0], id / tiles[0] % tiles[1], id / (tiles[0] * tiles[1])}};
  }
  bool has_tile(int x, int y, int z) const {
    return x >= 0 && x < tiles[0] && y >= 0 && y < tiles[1] && z >= 0 && z < tiles[2];
  }
  bool holds(const Vector& x) const {
    bool inside = true;
    for (std::size_t d = 0; d < static_cast<std::size_t>(patch.dimensions); ++d)
      inside = inside && x[d] >= lower[d] && x[d] < upper[d];
    return inside;
  }
};

/// A cell as its tile in the box and its place in the tile.
struct Cell {
  int tile = 0;
  int inside = 0;
};

/// @pre grid.holds(x)
inline Cell cell_of(const Grid& grid, const Vector& x) {
  const double per_cell = 1.0 / grid.cell_size;
  Cell cell;
  for (int d = grid.patch.dimensions - 1; d >= 0; --d) {
    const int c = static_cast<int>((x[static_cast<std::size_t>(d)] - grid.lower[d]) * per_cell);
    cell.tile = cell.tile * grid.tiles[d] + (c >> grid.patch.tile_bits);
    cell.inside = (cell.inside << grid.patch.tile_bits) + c % grid.patch.tile_cells;
  }
  return cell;
}

/// Rank that owns the tile around a point of the box.
inline int owner_of(const Grid& grid, const Vector& x) {
  return grid.owner[static_cast<std::size_t>(cell_of(grid, x).tile)];
}

}  // namespace barreno
