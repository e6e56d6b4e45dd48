// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/find_early_arrivals.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "base/rows.hpp"
#include "state/row_frames.hpp"
#include "step/order/remove_lost.hpp"
#include "step/subcycle/stray_rule.hpp"
#include "step/subcycle/tile_exits.hpp"

namespace barreno {
namespace {

/// Rows that a part has moved.
struct Found {
  int lost = 0, strays = 0, early = 0;
};
KOKKOS_INLINE_FUNCTION void add(const Found& from, Found& to) {
  to.lost += from.lost;
  to.strays += from.strays;
  to.early += from.early;
}

struct LookAtRow {
  CellLattice lattice;
  RowFrames frames;
  StrayRule rule;
  RemovalRule removal;
  TileDirectory directory;
  ArrayView<unsigned char> level_of_tile;
  Subcycling subcycling;

  LookAtRow(const Grid& grid, const Particles& particles, const Subcycling& of_step)
      : lattice(grid),
        frames(grid, particles),
        rule(grid, particles),
        removal(grid, particles),
        directory(grid.directory),
        level_of_tile(grid.level_of_tile),
        subcycling(of_step) {}

  KOKKOS_INLINE_FUNCTION bool has_moved(int p) const {
    return subcycling.ends(frames.tile(p)) != 0;
  }
  KOKKOS_INLINE_FUNCTION bool is_stray(int p) const {
    return rule.is_stray(p, frames.tile_frame(frames.tile(p)));
  }
  KOKKOS_INLINE_FUNCTION bool is_foreseen_of(int p, int from) const {
    int away[3] = {};
    for (int d = 0; d < rule.dimensions; ++d)
      away[d] = rule.tiles_away(rule.cells_along(d, p, frames.tile_frame(from)));
    return is_foreseen(subcycling, from, away);
  }
  /// What was not foreseen is early even if an active tile is there: which of the empty ones are
  /// active depends on what was before, and no answer must.
  KOKKOS_INLINE_FUNCTION bool is_early(int p, const Cell& cell, int from) const {
    // Of another rank's finer tiles it is not known here which are active.
    if (level_of_tile.extent(0) > 0 &&
        level_of_tile(cell.box_tile) > frames.tile_frame(from).position.level)
      return true;
    const int to = directory(cell.tile);
    if (to == from) return false;
    return !is_foreseen_of(p, from) || to < 0 || (subcycling.part + 1) % subcycling.period(to) != 0;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int p, Found& found) const {
    if (!has_moved(p)) return;
    if (removal.is_lost(p)) {
      ++found.lost;
    } else if (is_stray(p)) {
      ++found.strays;
      found.early += is_early(p, lattice.cell_at(removal.position, p), frames.tile(p)) ? 1 : 0;
    }
  }
};

Found look_at_rows(const Grid& grid, const Particles& particles, const Subcycling& subcycling) {
  const LookAtRow look(grid, particles, subcycling);
  const ArrayView<unsigned char> chunk_part = particles.chunk_part;
  Found found;
  launch_reduction(
      "find_early_arrivals",
      range(particles.count),
      KOKKOS_LAMBDA(const int p, Found& sum) {
        if (chunk_part(p / rows_per_chunk) != no_part_of_chunk) look(p, sum);
      },
      TallyReducer<Found>(found)
  );
  return found;
}

/// @return how many of them are in tiles of other ranks
int find_keys_of_strays(
    const Grid& grid, const Subcycling& subcycling, const Particles& particles
) {
  const LookAtRow look(grid, particles, subcycling);
  const ArrayView<CellKey> key = particles.key;
  const int active = grid.active, cells = grid.patch.cells;
  int left = 0;
  launch_reduction(
      "find_keys_of_strays",
      range(particles.count),
      KOKKOS_LAMBDA(const int p, int& sum) {
        if (!look.has_moved(p) || !look.is_stray(p)) return;
        const Cell cell = look.lattice.cell_at(look.removal.position, p);
        const int tile = look.directory(cell.tile);
        const bool here = tile >= 0 && tile < active;
        key(p) = here ? CellKey{tile * cells + cell.inside} : CellKey::unplaced;
        sum += here ? 0 : 1;
      },
      left
  );
  return left;
}

}  // namespace

Arrivals find_early_arrivals(
    const Grid& grid, const std::vector<Particles>& sets, const Subcycling& subcycling
) {
  const Region region("find_early_arrivals");
  Found all;
  for (const Particles& particles : sets) add(look_at_rows(grid, particles, subcycling), all);
  return {all.lost + all.strays > 0, all.early > 0};
}

Placement place_strays(
    const Grid& grid, const Subcycling& subcycling, std::vector<Particles>& sets, OwnLedger& ledger
) {
  const Region region("place_strays");
  Placement placement;
  for (Particles& particles : sets) {
    const Found found = look_at_rows(grid, particles, subcycling);
    if (found.lost > 0) remove_lost(grid, particles, ledger);
    if (found.strays == 0) continue;
    if (find_keys_of_strays(grid, subcycling, particles) > 0) placement.someone_left = true;
    particles.sorted = false;
  }
  return placement;
}

}  // namespace barreno
