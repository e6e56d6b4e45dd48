// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/patch.hpp"
#include "scene/scene.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace barreno {

/// The communication plan between the ranks that share tiles (Tpetra); hidden to keep compile times
/// low.
struct HaloPlan;

/// Position of a tile in the box, in tiles along x, y, z.
struct TilePosition {
  int along[3] = {0, 0, 0};
  KOKKOS_INLINE_FUNCTION int operator[](int axis) const { return along[axis]; }
};

/// What a kernel may know of a tile beside its patch: where it lies, how large its cells are and
/// how long its step is. Both differ from tile to tile once tiles are refined or step by
/// themselves.
struct TileFrame {
  TilePosition position;
  double cell_size = 0.0;  ///< [length]
  double dt = 0.0;         ///< of the step that is taken [time]
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
  double cell_size = 0.0;       ///< of the box's lattice; kernels read TileFrame::cell_size
  std::string shape;            ///< word of the particles' shape function (shape/visit_kernels.hpp)
  double largest_domain = 1.0;  ///< corners further from x_p are pulled in [cells]
  bool mirrored[6] = {};        ///< by Face: a symmetry plane that the deck asks for
  int cells[3] = {0, 0, 1};
  int tiles[3] = {0, 0, 1};  ///< of the whole box, active or not

  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  std::vector<int> owner;        ///< rank of every tile of the box; set_owners changes it
  ArrayView<int> owner_of_tile;  ///< the same for kernels

  long activations = 0;  ///< times that the local tiles were numbered anew
  int active = 0;        ///< tiles that this rank owns and stores
  int ghosts = 0;  ///< tiles of other ranks whose patch overlaps one of ours, stored behind ours
  ArrayView<TileFrame> tile_frame;  ///< of the active tiles and the ghosts
  ArrayView<int> directory;         ///< tile of the box -> local tile, or -1
  ArrayView<int>
      neighbours;  ///< tile * patch.neighbours + k -> local tile (ghosts included), or -1
  ArrayView<unsigned char>
      counts;  ///< tile * patch.size + slot: 1 if this tile's copy of the node counts
  std::shared_ptr<HaloPlan> halo;

  int tile_id(int x, int y, int z) const { return (z * tiles[1] + y) * tiles[0] + x; }
  TilePosition position_of_tile(int id) const {
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

/// The cells of the box as kernels take them.
struct CellLattice {
  int dimensions, tile_bits, tile_cells;
  double cells_per_length;
  double lower[3];
  int tiles[3];

  explicit CellLattice(const Grid& grid)
      : dimensions(grid.patch.dimensions),
        tile_bits(grid.patch.tile_bits),
        tile_cells(grid.patch.tile_cells),
        cells_per_length(1.0 / grid.cell_size),
        lower{grid.lower[0], grid.lower[1], grid.lower[2]},
        tiles{grid.tiles[0], grid.tiles[1], grid.tiles[2]} {}

  /// @param x  coordinate(axis) of a point that the box holds
  template <class Coordinate>
  KOKKOS_INLINE_FUNCTION Cell cell_at(const Coordinate& x) const {
    Cell cell;
    for (int d = dimensions - 1; d >= 0; --d) {
      const int c = static_cast<int>((x(d) - lower[d]) * cells_per_length);
      cell.tile = cell.tile * tiles[d] + (c >> tile_bits);
      cell.inside = (cell.inside << tile_bits) + c % tile_cells;
    }
    return cell;
  }
  KOKKOS_INLINE_FUNCTION Cell cell_at(const FieldView& position, int row) const {
    return cell_at([&](int d) { return position(row, d); });
  }
};

/// @pre grid.holds(x)
inline Cell cell_of(const Grid& grid, const Vector& x) {
  return CellLattice(grid).cell_at([&](int d) { return x[static_cast<std::size_t>(d)]; });
}

/// Rank that owns the tile around a point of the box.
inline int owner_of(const Grid& grid, const Vector& x) {
  return grid.owner[static_cast<std::size_t>(cell_of(grid, x).tile)];
}

}  // namespace barreno
