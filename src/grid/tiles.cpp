// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"

#include "base/region.hpp"
#include "grid/halo.hpp"

#include <cmath>

namespace barreno {
namespace {

void find_neighbours(Grid& grid) {
  for (int t = 0; t < grid.active; ++t) {
    const TilePlace at = grid.tile_place(t);
    for_each_neighbour(grid.patch, [&](int k, int dx, int dy, int dz) {
      const int x = at[0] + dx, y = at[1] + dy, z = at[2] + dz;
      grid.neighbours(t * grid.patch.neighbours + k) =
          grid.has_tile(x, y, z) ? grid.directory(static_cast<std::size_t>(grid.tile_id(x, y, z)))
                                 : -1;
    });
  }
}

/// Slots [begin, end) along one axis that a patch shares with one `offset` tiles away.
struct Overlap {
  int begin = 0, end = 1;
};
Overlap overlap(const Patch& patch, int axis, int offset) {
  if (axis >= patch.dimensions) return {};
  return {patch.overlap_begin(offset), patch.overlap_end(offset)};
}

/// A node counts in the first tile, in lexicographic order, whose patch holds it.
void find_counting_copies(Grid& grid) {
  const Patch& patch = grid.patch;
  Kokkos::deep_copy(grid.counts, static_cast<unsigned char>(1));
  for (int t = 0; t < grid.active; ++t)
    for_each_neighbour(patch, [&](int k, int dx, int dy, int dz) {
      if (k >= patch.neighbours / 2 || grid.neighbours(t * patch.neighbours + k) < 0) return;
      const Overlap in_x = overlap(patch, 0, dx);
      const Overlap in_y = overlap(patch, 1, dy);
      const Overlap in_z = overlap(patch, 2, dz);
      for (int z = in_z.begin; z < in_z.end; ++z)
        for (int y = in_y.begin; y < in_y.end; ++y)
          for (int x = in_x.begin; x < in_x.end; ++x)
            grid.counts(t * patch.size + (z * patch.nodes + y) * patch.nodes + x) = 0;
    });
}

}  // namespace

Grid make_grid(
    const GridSpec& spec, int reach, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
) {
  Grid grid;
  grid.patch = make_patch(dimensions(spec.mode), reach);
  grid.mode = spec.mode;
  grid.cell_size = spec.cell_size;
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
  grid.owner.assign(n, 0);
  grid.directory = ArrayView<int>("directory", n);
  Kokkos::deep_copy(grid.directory, -1);
  return grid;
}

void activate_tiles(Grid& grid, const std::vector<int>& owned) {
  const Region region("activate_tiles");
  for (int t = 0; t < grid.active + grid.ghosts; ++t) {
    const TilePlace& at = grid.tile_place(t);
    grid.directory(static_cast<std::size_t>(grid.tile_id(at[0], at[1], at[2]))) = -1;
  }

  ++grid.activations;
  const std::vector<int> ghosts = build_halo(grid, owned);
  grid.active = static_cast<int>(owned.size());
  grid.ghosts = static_cast<int>(ghosts.size());
  std::vector<int> local(owned);
  local.insert(local.end(), ghosts.begin(), ghosts.end());

  const auto n = static_cast<std::size_t>(grid.active);
  grid.tile_place = ArrayView<TilePlace>("tile_place", local.size());
  grid.neighbours =
      ArrayView<int>("neighbours", n * static_cast<std::size_t>(grid.patch.neighbours));
  grid.counts = ArrayView<unsigned char>("counts", n * static_cast<std::size_t>(grid.patch.size));
  for (std::size_t t = 0; t < local.size(); ++t) {
    grid.tile_place(t) = grid.place_of_tile(local[t]);
    grid.directory(static_cast<std::size_t>(local[t])) = static_cast<int>(t);
  }
  find_neighbours(grid);
  find_counting_copies(grid);
}

}  // namespace barreno
