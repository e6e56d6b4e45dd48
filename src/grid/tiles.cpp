// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"

#include "base/region.hpp"
#include "grid/halo.hpp"

#include <cmath>

namespace barreno {
namespace {

/// Slots that a patch shares with its neighbour at offset -1, 0 or +1 in one direction.
struct Overlap {
  int begin, end;
};
Overlap overlap(int offset) {
  if (offset < 0) return {0, patch_nodes - tile_cells};
  if (offset > 0) return {tile_cells, patch_nodes};
  return {0, patch_nodes};
}

void find_neighbours(Grid& grid) {
  for (int t = 0; t < grid.active; ++t)
    for (int k = 0; k < neighbour_count; ++k) {
      const int x = grid.tile_x(t) + k % 3 - 1;
      const int y = grid.tile_y(t) + k / 3 - 1;
      const bool inside = x >= 0 && x < grid.tiles[0] && y >= 0 && y < grid.tiles[1];
      grid.neighbours(t * neighbour_count + k) =
          inside ? grid.directory(static_cast<std::size_t>(grid.tile_id(x, y))) : -1;
    }
}

/// A node counts in the first tile, in lexicographic order, whose patch holds it.
void find_counting_copies(Grid& grid) {
  Kokkos::deep_copy(grid.counts, static_cast<unsigned char>(1));
  for (int t = 0; t < grid.active; ++t)
    for (int k = 0; k < neighbour_count / 2; ++k) {
      if (grid.neighbours(t * neighbour_count + k) < 0) continue;
      const Overlap in_x = overlap(k % 3 - 1);
      const Overlap in_y = overlap(k / 3 - 1);
      for (int y = in_y.begin; y < in_y.end; ++y)
        for (int x = in_x.begin; x < in_x.end; ++x)
          grid.counts(t * patch_size + y * patch_nodes + x) = 0;
    }
}

}  // namespace

Grid make_grid(const GridSpec& spec, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  Grid grid;
  grid.mode = spec.mode;
  grid.cell_size = spec.cell_size;
  grid.comm = comm;
  for (int d = 0; d < 2; ++d) {
    const auto i = static_cast<std::size_t>(d);
    grid.lower[d] = spec.lower[i];
    grid.upper[d] = spec.upper[i];
    // A box that is a whole number of cells up to round-off has that number.
    grid.cells[d] =
        static_cast<int>(std::ceil((spec.upper[i] - spec.lower[i]) / spec.cell_size - 1e-9));
    grid.tiles[d] = (grid.cells[d] + tile_cells - 1) / tile_cells;
  }
  const auto n = static_cast<std::size_t>(grid.tiles[0]) * static_cast<std::size_t>(grid.tiles[1]);
  grid.owner.assign(n, 0);
  grid.directory = ArrayView<int>("directory", n);
  Kokkos::deep_copy(grid.directory, -1);
  return grid;
}

void activate_tiles(Grid& grid, const std::vector<int>& owned) {
  const Region region("activate_tiles");
  for (int t = 0; t < grid.active + grid.ghosts; ++t)
    grid.directory(static_cast<std::size_t>(grid.tile_id(grid.tile_x(t), grid.tile_y(t)))) = -1;

  const std::vector<int> ghosts = build_halo(grid, owned);
  grid.active = static_cast<int>(owned.size());
  grid.ghosts = static_cast<int>(ghosts.size());
  std::vector<int> local(owned);
  local.insert(local.end(), ghosts.begin(), ghosts.end());

  const auto n = static_cast<std::size_t>(grid.active);
  grid.tile_x = ArrayView<int>("tile_x", local.size());
  grid.tile_y = ArrayView<int>("tile_y", local.size());
  grid.neighbours = ArrayView<int>("neighbours", n * neighbour_count);
  grid.counts = ArrayView<unsigned char>("counts", n * patch_size);
  for (std::size_t t = 0; t < local.size(); ++t) {
    grid.tile_x(t) = local[t] % grid.tiles[0];
    grid.tile_y(t) = local[t] / grid.tiles[0];
    grid.directory(static_cast<std::size_t>(local[t])) = static_cast<int>(t);
  }
  find_neighbours(grid);
  find_counting_copies(grid);
}

}  // namespace barreno
