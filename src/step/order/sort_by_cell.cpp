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

void clear_counts(int keys, const Particles& particles) {
  const ArrayView<int> end = particles.cell_end;
  launch(
      "clear_counts", range(keys + 1), KOKKOS_LAMBDA(const int k) { end(k) = 0; }
  );
}

/// cell_end: rows of every cell.
void count_in_cells(const Particles& particles) {
  const ArrayView<int> end = particles.cell_end;
  const ArrayView<CellKey> key = particles.key;
  launch(
      "count_in_cells",
      range(particles.count),
      KOKKOS_LAMBDA(const int p) { fetch_add(end(index_of(key(p))), 1); }
  );
}

/// cell_begin of every cell and of the one past the last; cell_end the same, to count on from.
void add_counts(int keys, const Particles& particles) {
  const ArrayView<int> begin = particles.cell_begin, end = particles.cell_end;
  launch_scan(
      "add_counts",
      range(keys + 1),
      KOKKOS_LAMBDA(const int k, int& sum, const bool last) {
        const int count = end(k);
        if (last) begin(k) = end(k) = sum;
        sum += count;
      }
  );
}

/// Rows of every cell, in any order.
void list_rows(const Particles& particles) {
  const ArrayView<int> end = particles.cell_end, order = particles.order;
  const ArrayView<CellKey> key = particles.key;
  launch(
      "list_rows",
      range(particles.count),
      KOKKOS_LAMBDA(const int p) { order(fetch_add(end(index_of(key(p))), 1)) = p; }
  );
}

/// The rows of every cell by id, and where those of a tile begin.
void sort_by_id(int cells, int tiles, const Particles& particles) {
  const ArrayView<int> begin = particles.cell_begin;
  const ArrayView<int> order = particles.order, tile_begin = particles.tile_begin;
  const ArrayView<ParticleId> id = particles.id;
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
  clear_counts(keys, particles);
  count_in_cells(particles);
  add_counts(keys, particles);
  list_rows(particles);
  sort_by_id(grid.patch.cells, grid.active, particles);
  particles.sorted = true;
}

}  // namespace barreno
