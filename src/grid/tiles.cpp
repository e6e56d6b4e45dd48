// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"

#include "base/error.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/view_of.hpp"
#include "grid/halo.hpp"
#include "grid/make_patch.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace barreno {
namespace {

void find_neighbours(const Grid& grid) {
  const BoxTiles box = grid.box;
  const Patch patch = grid.patch;
  const ArrayView<TileFrame> frame = grid.tile_frame;
  const TileDirectory directory = grid.directory;
  const ArrayView<int> neighbours = grid.neighbours;
  launch(
      "find_neighbours",
      range(grid.active),
      KOKKOS_LAMBDA(const int t) {
        const TilePosition at = frame(t).position;
        for_each_neighbour(patch, [&](int k, int dx, int dy, int dz) {
          const TilePosition beside{{at[0] + dx, at[1] + dy, at[2] + dz}, at.level};
          neighbours(t * patch.neighbours + k) = box.has(beside) ? directory(box.id(beside)) : -1;
        });
      }
  );
}

/// A node counts in the first tile, in lexicographic order, whose patch holds it.
void find_counting_copies(const Grid& grid) {
  const Patch patch = grid.patch;
  const ArrayView<int> neighbours = grid.neighbours;
  const ArrayView<unsigned char> counts = grid.counts;
  Kokkos::deep_copy(counts, static_cast<unsigned char>(1));
  launch(
      "find_counting_copies",
      range(grid.active),
      KOKKOS_LAMBDA(const int t) {
        for_each_neighbour(patch, [&](int k, int dx, int dy, int dz) {
          if (k >= patch.neighbours / 2 || neighbours(t * patch.neighbours + k) < 0) return;
          for_each_shared_slot(patch, {dx, dy, dz}, [&](int slot) {
            counts(t * patch.size + slot) = 0;
          });
        });
      }
  );
}

/// Which nodes a refined tile takes from the coarser lattice.
struct FindParents {
  Patch patch;
  BoxTiles box;
  int cells[3];  ///< of the box at level 0
  bool mirrored[6];
  ArrayView<unsigned char> level_of_tile;
  ArrayView<TileFrame> frame;
  TileDirectory directory;
  ArrayView<int> parent;
  ArrayView<unsigned char> from_parent, counts;

  explicit FindParents(const Grid& grid)
      : patch(grid.patch),
        box(grid.box),
        cells{grid.cells[0], grid.cells[1], grid.cells[2]},
        level_of_tile(grid.level_of_tile),
        frame(grid.tile_frame),
        directory(grid.directory),
        parent(grid.parent),
        from_parent(grid.from_parent),
        counts(grid.counts) {
    for (int face = 0; face < 6; ++face) mirrored[face] = grid.mirrored[face];
  }

  /// A cell, by its place on the lattice of a level, belongs to tiles as fine as that level; so do
  /// those outside the box, which have no say.
  KOKKOS_INLINE_FUNCTION bool is_fine(const int (&cell)[3], int level) const {
    TilePosition at{{}, level};
    for (int d = 0; d < patch.dimensions; ++d) {
      if (cell[d] < 0) return true;
      at.along[d] = cell[d] >> patch.tile_bits;
    }
    return !box.has(at) || level_of_tile(box.box_tile(at)) >= level;
  }
  /// All cells around a node are that fine.
  KOKKOS_INLINE_FUNCTION bool is_inside(const int (&node)[3], int level) const {
    for (int corner = 0; corner < 1 << patch.dimensions; ++corner) {
      int cell[3] = {};
      for (int d = 0; d < patch.dimensions; ++d) cell[d] = node[d] - (corner >> d & 1);
      if (!is_fine(cell, level)) return false;
    }
    return true;
  }
  KOKKOS_INLINE_FUNCTION bool is_on_parent(const int (&node)[3]) const {
    bool even = true;
    for (int d = 0; d < patch.dimensions; ++d) even = even && (node[d] & 1) == 0;
    return even;
  }
  /// Such nodes follow their images.
  KOKKOS_INLINE_FUNCTION bool is_behind_mirror(const int (&node)[3], int level) const {
    bool behind = false;
    for (int d = 0; d < patch.dimensions; ++d)
      behind = behind || (mirrored[2 * d] && node[d] < 0) ||
               (mirrored[2 * d + 1] && node[d] > cells[d] << level);
    return behind;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int t) const {
    const TilePosition at = frame(t).position;
    parent(t) = at.level > 0 ? directory(box.id(box.parent(at))) : -1;
    for (int slot = 0; slot < patch.size; ++slot) {
      int node[3];
      position_of_slot(patch, slot, node);
      for (int d = 0; d < patch.dimensions; ++d) node[d] += at[d] * patch.tile_cells - patch.reach;
      const bool taken = at.level > 0 && !is_behind_mirror(node, at.level) &&
                         (is_on_parent(node) || !is_inside(node, at.level));
      from_parent(t * patch.size + slot) = taken ? 1 : 0;
      if (taken) counts(t * patch.size + slot) = 0;
    }
  }
};

void find_parents(Grid& grid) {
  if (!grid.is_refined()) return;
  const auto n = static_cast<std::size_t>(grid.active);
  grid.parent = ArrayView<int>("parent", n);
  grid.from_parent =
      ArrayView<unsigned char>("from_parent", n * static_cast<std::size_t>(grid.patch.size));
  launch("find_parents", range(grid.active), FindParents(grid));
}

/// Tiles are numbered level by level.
void find_levels(const std::vector<int>& owned, Grid& grid) {
  for (int l = 0; l <= max_level + 1; ++l) {
    const auto first = std::lower_bound(owned.begin(), owned.end(), grid.box.first_id[l]);
    grid.first_of_level[l] = static_cast<int>(first - owned.begin());
  }
}

void make_frames(const std::vector<int>& local, Grid& grid) {
  grid.tile_frame = ArrayView<TileFrame>("frame", local.size());
  const auto frame = Kokkos::create_mirror_view(grid.tile_frame);
  for (std::size_t t = 0; t < local.size(); ++t) {
    const TilePosition at = grid.box.position(local[t]);
    frame(t) = {at, grid.cell_size / (1 << at.level), 0.0, 0.0};
  }
  Kokkos::deep_copy(grid.tile_frame, frame);
}

void set_levels(const std::vector<unsigned char>& level_of_tile, Grid& grid) {
  grid.host_level_of_tile = level_of_tile;
  grid.level_of_tile = ArrayView<unsigned char>("level_of_tile", level_of_tile.size());
  const auto copy = Kokkos::create_mirror_view(grid.level_of_tile);
  for (std::size_t t = 0; t < level_of_tile.size(); ++t) copy(t) = level_of_tile[t];
  Kokkos::deep_copy(grid.level_of_tile, copy);
}

}  // namespace

Grid make_grid(const Scene& scene, int reach, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const GridSpec& spec = scene.grid;
  Grid grid;
  grid.patch = make_patch(dimensions(spec.mode), reach, tile_bits_of(spec));
  grid.mode = spec.mode;
  grid.cell_size = spec.cell_size;
  grid.shape = scene.step.shape;
  grid.largest_domain = scene.step.largest_domain;
  for (const ConditionSpec& condition : scene.conditions)
    if (condition.kind == ConditionKind::symmetry)
      grid.mirrored[static_cast<std::size_t>(condition.face)] = true;
  grid.comm = comm;
  const std::array<int, 3> tiles = box_tiles(spec);
  for (int d = 0; d < grid.patch.dimensions; ++d) {
    const auto i = static_cast<std::size_t>(d);
    grid.lower[d] = spec.lower[i];
    grid.upper[d] = spec.upper[i];
    // A box that is a whole number of cells up to round-off has that number.
    grid.cells[d] =
        static_cast<int>(std::ceil((spec.upper[i] - spec.lower[i]) / spec.cell_size - 1e-9));
    grid.tiles[d] = tiles[i];
  }
  grid.box = BoxTiles(grid.patch.dimensions, finest_level(spec) + 1, grid.tiles);
  set_levels(spec.level_of_tile, grid);
  grid.parcels = Parcels(grid.patch.dimensions, grid.tiles, spec.most_parcels);
  set_owners(std::vector<int>(grid.parcels.count(), 0), grid);
  grid.directory = make_tile_directory(grid.box.first_id[grid.box.levels]);
  return grid;
}

void set_owners(const std::vector<int>& owner, Grid& grid) {
  grid.owner = owner;
  grid.owner_of_tile = {grid.parcels, view_of("owner", owner)};
}

void share_parcels(const std::vector<ParcelCost>& particles, Grid& grid) {
  const int ranks = grid.comm->getSize();
  const std::vector<int> owner = bisect_parcels(grid.parcels.along, particles, ranks);
  const double most = step_cost(owner, particles, ranks);  // of the rank that has most
  if (most > std::numeric_limits<int>::max())
    throw DeckError(
        "The deck gives a rank " + std::to_string(static_cast<long long>(most)) +
        " particles, which are counted in 32 bits; run it on more ranks."
    );
  set_owners(owner, grid);
}

void activate_tiles(Grid& grid, const std::vector<int>& owned) {
  const Region region("activate_tiles");
  ++grid.activations;
  const std::vector<int> ghosts = build_halo(grid, owned);
  grid.active = static_cast<int>(owned.size());
  grid.ghosts = static_cast<int>(ghosts.size());
  std::vector<int> local(owned);
  local.insert(local.end(), ghosts.begin(), ghosts.end());

  const auto n = static_cast<std::size_t>(grid.active);
  grid.neighbours =
      ArrayView<int>("neighbours", n * static_cast<std::size_t>(grid.patch.neighbours));
  grid.counts = ArrayView<unsigned char>("counts", n * static_cast<std::size_t>(grid.patch.size));
  list_tiles(local, grid.directory);
  make_frames(local, grid);
  find_levels(owned, grid);
  find_neighbours(grid);
  find_counting_copies(grid);
  find_parents(grid);
}

void set_part_of_steps(const Grid& grid, double dt) {
  const ArrayView<TileFrame> frame = grid.tile_frame;
  launch(
      "set_part_of_steps",
      RowPolicy(0, grid.active + grid.ghosts),
      KOKKOS_LAMBDA(const int tile) { frame(tile).part = dt; }
  );
}

void set_tile_steps(const Grid& grid, double dt) {
  const ArrayView<TileFrame> frame = grid.tile_frame;
  launch(
      "set_tile_steps",
      RowPolicy(0, grid.active + grid.ghosts),
      KOKKOS_LAMBDA(const int tile) { frame(tile).dt = frame(tile).part = dt; }
  );
}

}  // namespace barreno
