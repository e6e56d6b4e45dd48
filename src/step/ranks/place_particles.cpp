// SPDX-License-Identifier: BSD-3-Clause
#include "step/ranks/place_particles.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/tiles.hpp"
#include "step/order/sort_by_cell.hpp"
#include "step/ranks/migrate_particles.hpp"

namespace barreno {
namespace {

/// Marks the tiles that hold rows of a set, by number (BoxTiles).
void mark_tiles(
    const CellLattice& lattice, const Particles& particles, const ArrayView<unsigned char>& holds
) {
  const FieldView position = particles.position.values;
  launch(
      "mark_tiles",
      range(particles.count),
      KOKKOS_LAMBDA(const int p) { holds(lattice.cell_at(position, p).tile) = 1; }
  );
}

/// Marks the coarser tiles around those that are marked.
template <class Marks>
void mark_coarser_tiles(const BoxTiles& box, const Marks& marked) {
  for (int id = box.first_id[box.levels] - 1; id >= box.first_id[1]; --id)
    if (marked(static_cast<std::size_t>(id)) != 0)
      marked(static_cast<std::size_t>(box.id(box.parent(box.position(id))))) = 1;
}

/// Tiles that hold particles of this rank, and the coarser ones around them, by number, ascending.
std::vector<int> occupied_tiles(const Grid& grid, const std::vector<Particles>& sets) {
  const ArrayView<unsigned char> holds("occupied_tiles", grid.directory.extent(0));
  for (const Particles& particles : sets) mark_tiles(CellLattice(grid), particles, holds);
  const auto marked = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), holds);
  mark_coarser_tiles(grid.box, marked);
  std::vector<int> tiles;
  for (std::size_t t = 0; t < marked.extent(0); ++t)
    if (marked(t) != 0) tiles.push_back(static_cast<int>(t));
  return tiles;
}

}  // namespace

void forget_keys(std::vector<Particles>& sets) {
  for (Particles& particles : sets) particles.settled_chunks = 0;
}

void place_particles(
    const Placement& agreed,
    long step,
    Grid& grid,
    std::vector<Particles>& sets,
    OwnLedger& ledger,
    Effort& effort
) {
  const Region region("place_particles");
  if (agreed.someone_left) {
    const std::vector<int> first_row = migrate_particles(grid, sets);
    for (std::size_t s = 0; s < sets.size(); ++s) locate_newcomers(grid, sets[s], first_row[s]);
  }
  if (agreed.new_tile) {
    activate_tiles(grid, occupied_tiles(grid, sets));
    forget_keys(sets);
    locate_particles(grid, sets, ledger, effort);
    for (Particles& particles : sets) particles.sorted = false;
  }
  const Stopwatch watch;
  for (Particles& particles : sets) {
    if (particles.sorted) continue;
    sort_by_cell(grid, particles);
    if (step % steps_per_permutation == 0) permute_rows(particles);
  }
  effort.tile_seconds += watch.seconds();
}

void give_tiles(
    const std::vector<int>& owner,
    long step,
    Grid& grid,
    std::vector<Particles>& sets,
    OwnLedger& ledger,
    Effort& effort
) {
  const Region region("give_tiles");
  set_owners(owner, grid);
  // No tile is active in the new partition: everybody is looked for afresh.
  activate_tiles(grid, {});
  forget_keys(sets);
  locate_particles(grid, sets, ledger, effort);
  place_particles({true, true}, step, grid, sets, ledger, effort);
}

}  // namespace barreno
