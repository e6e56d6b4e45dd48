// SPDX-License-Identifier: BSD-3-Clause
#include "step/order/locate_particles.hpp"

#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "step/order/remove_lost.hpp"

#include <type_traits>

namespace barreno {
namespace {

/// What a look at every particle's cell has found.
struct Found {
  int outside = 0, moved = 0, beyond = 0;
};
KOKKOS_INLINE_FUNCTION void add(const Found& from, Found& to) {
  to.outside |= from.outside;
  to.moved |= from.moved;
  to.beyond |= from.beyond;
}

/// What a look at the rows beyond this rank's active tiles has found.
struct Beyond {
  int new_tile = 0, left = 0;
};
KOKKOS_INLINE_FUNCTION void add(const Beyond& from, Beyond& to) {
  to.new_tile |= from.new_tile;
  to.left |= from.left;
}

/// Keys of rows from their cells, without branches for the compiler to vectorise; rows outside the
/// grid or lost otherwise keep theirs.
template <unsigned D, bool Refined>
struct FindKeys {
  static constexpr int dimensions = D;
  double lower[D], upper[D];
  BoxTiles box;
  const double* position[D];
  double cells_per_length;
  int bits, in_tile, cells, active;
  const unsigned char* level_of_tile;
  const int *page_begin, *entry;  ///< TileDirectory
  CellKey* keys;
  const Fault* faults;

  FindKeys(const Grid& grid, const Particles& particles)
      : box(grid.box),
        cells_per_length(1.0 / grid.cell_size),
        bits(grid.patch.tile_bits),
        in_tile(grid.patch.tile_cells - 1),
        cells(grid.patch.cells),
        active(grid.active),
        level_of_tile(grid.level_of_tile.data()),
        page_begin(grid.directory.begin.data()),
        entry(grid.directory.entry.data()),
        keys(particles.key.data()),
        faults(particles.fault.data()) {
    for (int d = 0; d < dimensions; ++d) {
      lower[d] = grid.lower[d];
      upper[d] = grid.upper[d];
      position[d] = &particles.position(0, d);
    }
  }

  /// Cell of a row on the lattice of a level: the tile there, and the place in it. As in
  /// CellLattice.
  KOKKOS_FORCEINLINE_FUNCTION void find_cell(int p, int lost, int level, int& tile, int& inside)
      const {
    tile = inside = 0;
    const double per_length = Refined ? cells_per_length * (1 << level) : cells_per_length;
    for (int d = dimensions - 1; d >= 0; --d) {
      const int cell = static_cast<int>(lost ? 0.0 : (position[d][p] - lower[d]) * per_length);
      tile = tile * (box.along[d] << level) + (cell >> bits);
      inside = (inside << bits) + (cell & in_tile);
    }
  }

  KOKKOS_INLINE_FUNCTION Found operator()(int p) const {
    const CellKey old_key = keys[p];
    int lost = static_cast<int>(faults[p] != Fault::none);
    for (int d = 0; d < dimensions; ++d)
      lost |= static_cast<int>(!(position[d][p] >= lower[d])) |
              static_cast<int>(!(position[d][p] < upper[d]));
    int id = 0;
    int inside = 0;
    find_cell(p, lost, 0, id, inside);
    if constexpr (Refined) {
      const int level = level_of_tile[id];
      find_cell(p, lost, level, id, inside);
      id += box.first_id[level];
    }
    const int tile = entry[page_begin[TileDirectory::page(id)] + TileDirectory::in_page(id)];
    const int here = static_cast<int>(tile >= 0) & static_cast<int>(tile < active);
    const CellKey key = here ? CellKey{tile * cells + inside} : CellKey::unplaced;
    keys[p] = lost ? old_key : key;
    return {lost, static_cast<int>(key != old_key), (1 - lost) & (1 - here)};
  }
};

/// Where the rows are that are in no active tile of this rank. Few steps have such rows.
struct LookBeyond {
  CellLattice lattice;
  RemovalRule removal;
  ArrayView<CellKey> key;
  TileDirectory directory;
  TileOwners owner;
  int me;

  LookBeyond(const Grid& grid, const Particles& particles)
      : lattice(grid),
        removal(grid, particles),
        key(particles.key),
        directory(grid.directory),
        owner(grid.owner_of_tile),
        me(grid.comm->getRank()) {}

  /// Of other ranks' tiles those are active that are ghosts here; of others, further away, nothing
  /// is known.
  KOKKOS_INLINE_FUNCTION void operator()(int p, Beyond& found) const {
    if (is_placed(key(p)) || removal.is_lost(p)) return;
    const Cell cell = lattice.cell_at(removal.position, p);
    const bool mine = owner(cell.box_tile) == me;
    if (mine || directory(cell.tile) < 0) found.new_tile = 1;
    if (!mine) found.left = 1;
  }
};

Beyond look_beyond(const Grid& grid, const Particles& particles) {
  const LookBeyond look(grid, particles);
  Beyond found;
  launch_reduction(
      "look_beyond",
      range(particles.count),
      KOKKOS_LAMBDA(const int p, Beyond& some) { look(p, some); },
      TallyReducer<Beyond>(found)
  );
  return found;
}

/// Chunks whose rows have not moved since their keys were found.
struct SettledRows {
  int chunks = 0;
  ArrayView<unsigned char> part;

  KOKKOS_INLINE_FUNCTION bool holds(int chunk) const {
    return chunk < chunks && part(chunk) == no_part_of_chunk;
  }
};

template <class Keys>
Found find_keys(const Keys& key_of, int first_row, int count, const SettledRows& settled) {
  Found found;
  launch_reduction(
      "find_keys",
      range((count - first_row + rows_per_chunk - 1) / rows_per_chunk),
      KOKKOS_LAMBDA(const int chunk, Found& part) {
        const Keys find = key_of;  // its numbers do not change with what it writes
        if (settled.holds(chunk)) return;
        const int begin = first_row + chunk * rows_per_chunk;
        const int end = begin + rows_per_chunk < count ? begin + rows_per_chunk : count;
        Found some;
        BARRENO_IVDEP
        for (int p = begin; p < end; ++p) add(find(p), some);
        add(some, part);
      },
      TallyReducer<Found>(found)
  );
  return found;
}

Found find_keys(const Grid& grid, const Particles& particles, int first_row) {
  if (first_row >= particles.count) return {};
  const SettledRows settled{first_row == 0 ? particles.settled_chunks : 0, particles.chunk_part};
  const auto find = [&](auto dimensions, auto refined) {
    constexpr unsigned D = decltype(dimensions)::value;
    constexpr bool is_refined = decltype(refined)::value;
    return find_keys(FindKeys<D, is_refined>(grid, particles), first_row, particles.count, settled);
  };
  using Plane = std::integral_constant<unsigned, 2>;
  using Space = std::integral_constant<unsigned, 3>;
  if (grid.patch.dimensions == 3)
    return grid.is_refined() ? find(Space(), std::true_type()) : find(Space(), std::false_type());
  return grid.is_refined() ? find(Plane(), std::true_type()) : find(Plane(), std::false_type());
}

/// Keys of a set's rows; false if one is outside the grid or lost otherwise.
bool find_keys(const Grid& grid, Particles& particles, Placement& placement) {
  const Found found = find_keys(grid, particles, 0);
  if (found.beyond != 0) {
    const Beyond beyond = look_beyond(grid, particles);
    placement.new_tile = placement.new_tile || beyond.new_tile != 0;
    placement.someone_left = placement.someone_left || beyond.left != 0;
  }
  if (found.moved != 0) particles.sorted = false;
  return found.outside == 0;
}

}  // namespace

Placement locate_particles(const Continuum& continuum) {
  const Grid& grid = continuum.grid;
  const Region region("locate_particles");
  const Stopwatch watch;
  Placement placement;
  for (Particles& particles : continuum.sets) {
    if (find_keys(grid, particles, placement)) continue;
    remove_lost(grid, particles, continuum.ledger);
    find_keys(grid, particles, placement);
  }
  continuum.effort.tile_seconds += watch.seconds();
  return placement;
}

void locate_newcomers(const Grid& grid, const Particles& particles, int first_row) {
  find_keys(grid, particles, first_row);
}

}  // namespace barreno
