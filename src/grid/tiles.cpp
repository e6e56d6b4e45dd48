// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"

#include <cmath>

namespace barreno {
namespace {

/// Tiles of a box, for kernels.
struct BoxTiles {
  int along[3];
  KOKKOS_INLINE_FUNCTION bool has(int x, int y, int z) const {
    return x >= 0 && x < along[0] && y >= 0 && y < along[1] && z >= 0 && z < along[2];
  }
  KOKKOS_INLINE_FUNCTION int id(int x, int y, int z) const {
    return (z * along[1] + y) * along[0] + x;
  }
};

void find_neighbours(const Grid& grid) {
  const BoxTiles box{{grid.tiles[0], grid.tiles[1], grid.tiles[2]}};
  const Patch patch = grid.patch;
  const ArrayView<TileFrame> frame = grid.tile_frame;
  const ArrayView<int> directory = grid.directory, neighbours = grid.neighbours;
  launch(
      "find_neighbours",
      range(grid.active),
      KOKKOS_LAMBDA(const int t) {
        const TilePosition at = frame(t).position;
        for_each_neighbour(patch, [&](int k, int dx, int dy, int dz) {
          const int x = at[0] + dx, y = at[1] + dy, z = at[2] + dz;
          neighbours(t * patch.neighbours + k) = box.has(x, y, z) ? directory(box.id(x, y, z)) : -1;
        });
      }
  );
}

/// Slots [begin, end) along one axis that a patch shares with one `offset` tiles away.
struct Overlap {
  int begin = 0, end = 1;
};
KOKKOS_INLINE_FUNCTION Overlap overlap(const Patch& patch, int axis, int offset) {
  if (axis >= patch.dimensions) return {};
  return {patch.overlap_begin(offset), patch.overlap_end(offset)};
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
          const Overlap in_x = overlap(patch, 0, dx);
          const Overlap in_y = overlap(patch, 1, dy);
          const Overlap in_z = overlap(patch, 2, dz);
          for (int z = in_z.begin; z < in_z.end; ++z)
            for (int y = in_y.begin; y < in_y.end; ++y)
              for (int x = in_x.begin; x < in_x.end; ++x)
                counts(t * patch.size + (z * patch.nodes + y) * patch.nodes + x) = 0;
        });
      }
  );
}

/// Frames of the local tiles, and where the box finds them.
void enter_tiles(const std::vector<int>& local, const Grid& grid) {
  const auto frame = Kokkos::create_mirror_view(grid.tile_frame);
  for (std::size_t t = 0; t < local.size(); ++t)
    frame(t) = {grid.position_of_tile(local[t]), grid.cell_size, 0.0};
  Kokkos::deep_copy(grid.tile_frame, frame);
  const auto directory = Kokkos::create_mirror_view(grid.directory);
  Kokkos::deep_copy(directory, -1);
  for (std::size_t t = 0; t < local.size(); ++t)
    directory(static_cast<std::size_t>(local[t])) = static_cast<int>(t);
  Kokkos::deep_copy(grid.directory, directory);
}

}  // namespace

Grid make_grid(const Scene& scene, int reach, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const GridSpec& spec = scene.grid;
  Grid grid;
  grid.patch = make_patch(dimensions(spec.mode), reach);
  grid.mode = spec.mode;
  grid.cell_size = spec.cell_size;
  grid.shape = scene.step.shape;
  grid.largest_domain = scene.step.largest_domain;
  for (const ConditionSpec& condition : scene.conditions)
    if (condition.kind == ConditionKind::symmetry)
      grid.mirrored[static_cast<std::size_t>(condition.face)] = true;
  grid.comm = comm;
  for (int d = 0; d < grid.patch.dimensions; ++d) {
    const auto i = static_cast<std::size_t>(d);
    grid.lower[d] = spec.lower[i];
    grid.upper[d] = spec.upper[i];
    // A box that is a whole number of cells up to round-off has that number.
    grid.cells[d] =
        static_cast<int>(std::ceil((spec.upper[i] - spec.lower[i]) / spec.cell_size - 1e-9));
    grid.tiles[d] = (grid.cells[d] + grid.patch.tile_cells - 1) / grid.patch.tile_cells;
  }
  const auto n = static_cast<std::size_t>(grid.tile_id(0, 0, grid.tiles[2]));
  set_owners(std::vector<int>(n, 0), grid);
  grid.directory = ArrayView<int>("directory", n);
  Kokkos::deep_copy(grid.directory, -1);
  return grid;
}

void set_owners(const std::vector<int>& owner, Grid& grid) {
  grid.owner = owner;
  if (grid.owner_of_tile.extent(0) != owner.size())
    grid.owner_of_tile = ArrayView<int>("owner", owner.size());
  const auto copy = Kokkos::create_mirror_view(grid.owner_of_tile);
  for (std::size_t t = 0; t < owner.size(); ++t) copy(t) = owner[t];
  Kokkos::deep_copy(grid.owner_of_tile, copy);
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
  grid.tile_frame = ArrayView<TileFrame>("frame", local.size());
  grid.neighbours =
      ArrayView<int>("neighbours", n * static_cast<std::size_t>(grid.patch.neighbours));
  grid.counts = ArrayView<unsigned char>("counts", n * static_cast<std::size_t>(grid.patch.size));
  enter_tiles(local, grid);
  find_neighbours(grid);
  find_counting_copies(grid);
}

void set_tile_steps(const Grid& grid, double dt) {
  const ArrayView<TileFrame> frame = grid.tile_frame;
  launch(
      "set_tile_steps",
      RowPolicy(0, grid.active + grid.ghosts),
      KOKKOS_LAMBDA(const int tile) { frame(tile).dt = dt; }
  );
}

}  // namespace barreno
