// SPDX-License-Identifier: BSD-3-Clause
#include "step/order/sort_by_cell.hpp"

#include "base/launch.hpp"

namespace barreno {
namespace {

void make_room(std::size_t tiles, std::size_t keys, Particles& particles) {
  if (particles.cell_begin.extent(0) < keys + 1) {
    particles.cell_begin = ArrayView<int>("cell_begin", keys + keys / 4 + 1);
    particles.cell_end = ArrayView<int>("cell_end", keys + keys / 4 + 1);
  }
  if (particles.tile_begin.extent(0) < tiles + 1)
    particles.tile_begin = ArrayView<int>("tile_begin", tiles + tiles / 4 + 1);
}

/// cell_begin of every cell and of the one past the last; cell_end the same, to count on from.
void count_in_cells(int keys, const Particles& particles) {
  const ArrayView<int> begin = particles.cell_begin, end = particles.cell_end;
  const ArrayView<CellKey> key = particles.key;
  launch(
      "sort_clear", range(keys + 1), KOKKOS_LAMBDA(const int k) { end(k) = 0; }
  );
  launch(
      "sort_count",
      range(particles.count),
      KOKKOS_LAMBDA(const int p) { fetch_add(end(index_of(key(p))), 1); }
  );
  launch_scan(
      "sort_scan",
      range(keys + 1),
      KOKKOS_LAMBDA(const int k, int& sum, const bool last) {
        const int count = end(k);
        if (last) begin(k) = end(k) = sum;
        sum += count;
      }
  );
}

/// Rows of every cell, by id: rows fall into a cell in any order.
void list_rows(int cells, int tiles, const Particles& particles) {
  const ArrayView<int> begin = particles.cell_begin, end = particles.cell_end;
  const ArrayView<int> order = particles.order, tile_begin = particles.tile_begin;
  const ArrayView<CellKey> key = particles.key;
  const ArrayView<ParticleId> id = particles.id;
  launch(
      "sort_list",
      range(particles.count),
      KOKKOS_LAMBDA(const int p) { order(fetch_add(end(index_of(key(p))), 1)) = p; }
  );
  launch(
      "sort_by_id",
      range(tiles + 1),
      KOKKOS_LAMBDA(const int tile) {
        tile_begin(tile) = begin(tile * cells);
        if (tile == tiles) return;
        for (int cell = tile * cells; cell < (tile + 1) * cells; ++cell)
          for (int i = begin(cell) + 1; i < begin(cell + 1); ++i) {
            const int row = order(i);
            int place = i;
            for (; place > begin(cell) && id(order(place - 1)) > id(row); --place)
              order(place) = order(place - 1);
            order(place) = row;
          }
      }
  );
}

}  // namespace

void sort_by_cell(const Grid& grid, Particles& particles) {
  const int keys = grid.active * grid.patch.cells;
  make_room(static_cast<std::size_t>(grid.active), static_cast<std::size_t>(keys), particles);
  count_in_cells(keys, particles);
  list_rows(grid.patch.cells, grid.active, particles);
  particles.sorted = true;
}

}  // namespace barreno
