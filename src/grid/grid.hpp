// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/parcels.hpp"
#include "grid/patch.hpp"
#include "grid/tile_directory.hpp"
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

/// Position of a tile in the box, in tiles of its level along x, y, z.
struct TilePosition {
  int along[3] = {0, 0, 0};
  int level = 0;
  KOKKOS_INLINE_FUNCTION int operator[](int axis) const { return along[axis]; }
};

/// Tiles of all levels of a box, by number: those of level 0 first, x fastest. A tile of level l
/// has cells 2^l times smaller than the box's, and 2^l of them fill one of level 0 along each axis.
struct BoxTiles {
  int dimensions = 2;
  int levels = 1;
  int along[3] = {0, 0, 1};          ///< of level 0
  int first_id[max_level + 2] = {};  ///< of each level; behind the last, their number

  BoxTiles() = default;
  BoxTiles(int dimension, int count, const int (&of_box)[3])
      : dimensions(dimension), levels(count), along{of_box[0], of_box[1], of_box[2]} {
    for (int l = 0; l <= max_level; ++l)
      first_id[l + 1] =
          first_id[l] +
          (l < levels ? count_along(0, l) * count_along(1, l) * count_along(2, l) : 0);
  }

  KOKKOS_INLINE_FUNCTION int count_along(int axis, int level) const {
    return axis < dimensions ? along[axis] << level : 1;
  }
  KOKKOS_INLINE_FUNCTION bool has(const TilePosition& at) const {
    bool inside = true;
    for (int d = 0; d < 3; ++d) inside = inside && at[d] >= 0 && at[d] < count_along(d, at.level);
    return inside;
  }
  KOKKOS_INLINE_FUNCTION int id(const TilePosition& at) const {
    return first_id[at.level] +
           (at[2] * count_along(1, at.level) + at[1]) * count_along(0, at.level) + at[0];
  }
  KOKKOS_INLINE_FUNCTION TilePosition position(int id) const {
    TilePosition at;
    while (at.level + 1 < levels && id >= first_id[at.level + 1]) ++at.level;
    id -= first_id[at.level];
    const int x = count_along(0, at.level), y = count_along(1, at.level);
    at.along[0] = id % x;
    at.along[1] = id / x % y;
    at.along[2] = id / (x * y);
    return at;
  }
  /// The tile of the next coarser level that holds a tile of a level above 0.
  KOKKOS_INLINE_FUNCTION TilePosition parent(const TilePosition& at) const {
    return {{at[0] >> 1, at[1] >> 1, dimensions == 3 ? at[2] >> 1 : 0}, at.level - 1};
  }
  /// The tile of level 0 that holds a tile.
  KOKKOS_INLINE_FUNCTION int box_tile(const TilePosition& at) const {
    const int z = dimensions == 3 ? at[2] >> at.level : 0;
    return (z * along[1] + (at[1] >> at.level)) * along[0] + (at[0] >> at.level);
  }
};

/// visit(position) of the tiles of the next finer level that fill one, in the order of their
/// numbers; none if there is no finer level.
template <class Visitor>
KOKKOS_INLINE_FUNCTION void for_each_finer_tile(
    const BoxTiles& box, const TilePosition& at, const Visitor& visit
) {
  if (at.level + 1 >= box.levels) return;
  const int layers = box.dimensions == 3 ? 2 : 1;
  for (int z = 0; z < layers; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x)
        visit(TilePosition{{2 * at[0] + x, 2 * at[1] + y, layers * at[2] + z}, at.level + 1});
}

/// What a kernel may know of a tile beside its patch: where it lies, how large its cells are and
/// how long its step is. Both differ from tile to tile once tiles are refined or step by
/// themselves.
struct TileFrame {
  TilePosition position;
  double cell_size = 0.0;  ///< [length]
  double dt = 0.0;         ///< of the step that its particles take [time]
  double part = 0.0;  ///< what of it its nodes take at once; all of it without Subcycling [time]
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
  int tiles[3] = {0, 0, 1};  ///< of level 0 of the whole box, active or not
  BoxTiles box;
  /// Of every tile of level 0, as the deck refines it; empty: all have level 0. Particles are in
  /// tiles of that level; the coarser tiles around them are active too, and hold none.
  ArrayView<unsigned char> level_of_tile;
  std::vector<unsigned char> host_level_of_tile;  ///< the same

  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  Parcels parcels;
  std::vector<int> owner;    ///< rank of every parcel; set_owners changes it
  TileOwners owner_of_tile;  ///< the same for kernels

  long activations = 0;  ///< times that the local tiles were numbered anew
  int active = 0;        ///< tiles that this rank owns and stores
  int ghosts = 0;  ///< tiles of other ranks whose patch overlaps one of ours, stored behind ours
  int first_of_level[max_level + 2] = {};  ///< active tiles by level; behind the last, `active`
  ArrayView<TileFrame> tile_frame;         ///< of the active tiles and the ghosts
  TileDirectory directory;
  ArrayView<int>
      neighbours;  ///< tile * patch.neighbours + k -> local tile (ghosts included), or -1
  ArrayView<unsigned char>
      counts;  ///< tile * patch.size + slot: 1 if this tile's copy of the node counts
  /// Active tile -> the local tile that holds it at the next coarser level, or -1. Empty, as is the
  /// next, where nothing is refined.
  ArrayView<int> parent;
  /// tile * patch.size + slot: 1 if the node is none of the tile's own unknowns: it coincides with
  /// one of the coarser lattice, or lies on or beyond the border to larger cells and follows
  /// theirs.
  ArrayView<unsigned char> from_parent;
  /// (ghost - active) * patch.size + slot: 1 if a patch of ours holds the node too. Of ghosts no
  /// other sums are fetched.
  ArrayView<unsigned char> fetched;
  std::shared_ptr<HaloPlan> halo;

  bool is_refined() const { return box.levels > 1; }
  double smallest_cell() const { return cell_size / (1 << (box.levels - 1)); }
  bool holds(const Vector& x) const {
    bool inside = true;
    for (std::size_t d = 0; d < static_cast<std::size_t>(patch.dimensions); ++d)
      inside = inside && x[d] >= lower[d] && x[d] < upper[d];
    return inside;
  }
};

/// A cell as its tile, by number (BoxTiles) and by the tile of level 0 around it, and its place in
/// the tile.
struct Cell {
  int tile = 0;
  int box_tile = 0;
  int inside = 0;
};

/// The cells of the box as kernels take them.
struct CellLattice {
  int dimensions, tile_bits, tile_cells;
  double cells_per_length;  ///< of level 0
  double lower[3];
  BoxTiles box;
  ArrayView<unsigned char> level_of_tile;

  explicit CellLattice(const Grid& grid)
      : dimensions(grid.patch.dimensions),
        tile_bits(grid.patch.tile_bits),
        tile_cells(grid.patch.tile_cells),
        cells_per_length(1.0 / grid.cell_size),
        lower{grid.lower[0], grid.lower[1], grid.lower[2]},
        box(grid.box),
        level_of_tile(grid.level_of_tile) {}

  /// @param x  coordinate(axis) of a point that the box holds
  template <class Coordinate>
  KOKKOS_INLINE_FUNCTION Cell cell_at(const Coordinate& x) const {
    Cell cell = cell_of_level(x, 0);
    cell.box_tile = cell.tile;
    if (box.levels == 1) return cell;
    const int level = level_of_tile(cell.tile);
    if (level == 0) return cell;
    const int box_tile = cell.tile;
    cell = cell_of_level(x, level);
    cell.box_tile = box_tile;
    return cell;
  }
  /// On the lattice of a level, whether the tile there has it or not. Cells of the levels nest:
  /// products with powers of two are exact.
  template <class Coordinate>
  KOKKOS_INLINE_FUNCTION Cell cell_of_level(const Coordinate& x, int level) const {
    Cell cell;
    for (int d = dimensions - 1; d >= 0; --d) {
      const int c = static_cast<int>((x(d) - lower[d]) * (cells_per_length * (1 << level)));
      cell.tile = cell.tile * box.count_along(d, level) + (c >> tile_bits);
      cell.inside = (cell.inside << tile_bits) + c % tile_cells;
    }
    cell.tile += box.first_id[level];
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

/// Rank that owns a tile of level 0.
inline int owner_of(const Grid& grid, int box_tile) {
  return grid.owner[static_cast<std::size_t>(grid.parcels.holding(box_tile))];
}

/// Rank that owns the tile around a point of the box.
inline int owner_of(const Grid& grid, const Vector& x) {
  return owner_of(grid, cell_of(grid, x).box_tile);
}

}  // namespace barreno
