// SPDX-License-Identifier: BSD-3-Clause
#include "step/ranks/place_particles.hpp"

#include "base/exchange.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/tiles.hpp"
#include "step/order/sort_by_cell.hpp"
#include "step/ranks/migrate_particles.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace barreno {
namespace {

/// Tiles that hold rows: marks on those that are active, and a list of the others, with repeats.
struct HoldingTiles {
  ArrayView<unsigned char> active;
  ArrayView<int> others, count;  ///< of which the first `count` are filled
};

void look_for_tiles(const Grid& grid, const Particles& particles, const HoldingTiles& holding) {
  const CellLattice lattice(grid);
  const FieldView position = particles.position.values;
  const TileDirectory directory = grid.directory;
  const int active = grid.active;
  launch(
      "look_for_tiles",
      range(particles.count),
      KOKKOS_LAMBDA(const int p) {
        const int tile = lattice.cell_at(position, p).tile;
        const int local = directory(tile);
        if (local >= 0 && local < active)
          holding.active(local) = 1;
        else
          holding.others(fetch_add(holding.count(0), 1)) = tile;
      }
  );
}

/// Adds the coarser tiles around those of a list.
void add_coarser_tiles(const BoxTiles& box, std::vector<int>& tiles) {
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const TilePosition at = box.position(tiles[t]);
    if (at.level > 0) tiles.push_back(box.id(box.parent(at)));
  }
}

void sort_out_repeats(std::vector<int>& tiles) {
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

/// Of tiles that hold particles so many active ones may be empty: a tile that the pieces of a jet
/// enter and leave one after the other would else be new with each of them.
constexpr double empty_share = 0.125;

/// The active tiles by number, ascending.
std::vector<int> active_tiles(const Grid& grid) {
  const auto frame = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), grid.tile_frame);
  std::vector<int> active(static_cast<std::size_t>(grid.active));
  for (std::size_t t = 0; t < active.size(); ++t) active[t] = grid.box.id(frame(t).position);
  return active;
}

/// Adds those of the active tiles that are empty, unless they are many.
void keep_empty_tiles(const std::vector<int>& active, std::vector<int>& tiles) {
  std::vector<int> empty;
  std::set_difference(
      active.begin(), active.end(), tiles.begin(), tiles.end(), std::back_inserter(empty)
  );
  if (static_cast<double>(empty.size()) > empty_share * static_cast<double>(tiles.size())) return;
  const auto middle = static_cast<std::ptrdiff_t>(tiles.size());
  tiles.insert(tiles.end(), empty.begin(), empty.end());
  std::inplace_merge(tiles.begin(), tiles.begin() + middle, tiles.end());
}

/// Tiles that hold particles of this rank, those that some are about to enter, the coarser ones
/// around both, and few that are empty, by number, ascending. Most are active already; no place of
/// the box is looked at beside them.
std::vector<int> tiles_to_activate(
    const Grid& grid, const std::vector<Particles>& sets, const std::vector<int>& reached
) {
  const auto rows = std::accumulate(sets.begin(), sets.end(), 0, [](int sum, const Particles& set) {
    return sum + set.count;
  });
  const HoldingTiles holding{
      ArrayView<unsigned char>("holding_tiles", static_cast<std::size_t>(grid.active)),
      ArrayView<int>("holding_others", static_cast<std::size_t>(rows)),
      ArrayView<int>("holding_count", 1)};
  for (const Particles& particles : sets) look_for_tiles(grid, particles, holding);
  const auto on_host = [](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
  };
  const auto holds = on_host(holding.active);
  const auto others = on_host(holding.others);
  std::vector<int> tiles(others.data(), others.data() + on_host(holding.count)(0));
  tiles.insert(tiles.end(), reached.begin(), reached.end());
  sort_out_repeats(tiles);
  const std::vector<int> active = active_tiles(grid);
  for (std::size_t t = 0; t < active.size(); ++t)
    if (holds(t) != 0) tiles.push_back(active[t]);
  add_coarser_tiles(grid.box, tiles);
  sort_out_repeats(tiles);
  keep_empty_tiles(active, tiles);
  return tiles;
}

/// With the tiles that hold particles, and those that some are about to enter; all get new numbers.
void make_active(const std::vector<int>& reached, const Continuum& continuum) {
  activate_tiles(continuum.grid, tiles_to_activate(continuum.grid, continuum.sets, reached));
  forget_keys(continuum.sets);
  locate_particles(continuum);
  for (Particles& particles : continuum.sets) particles.sorted = false;
}

void sort_sets(long step, const Continuum& continuum) {
  const Stopwatch watch;
  for (Particles& particles : continuum.sets) {
    if (particles.sorted) continue;
    sort_by_cell(continuum.grid, particles);
    if (step % steps_per_permutation == 0) permute_rows(particles);
  }
  continuum.effort.tile_seconds += watch.seconds();
}

/// @param tiles  of any ranks
/// @return those of this rank that any rank has in its list
std::vector<int> tell_owners(const Grid& grid, const std::vector<int>& tiles) {
  std::vector<std::vector<double>> told(static_cast<std::size_t>(grid.comm->getSize()));
  for (const int tile : tiles)
    told[static_cast<std::size_t>(owner_of(grid, grid.box.box_tile(grid.box.position(tile))))]
        .push_back(tile);
  const std::vector<double> heard = exchange_rows(*grid.comm, told);
  return {heard.begin(), heard.end()};
}

}  // namespace

void forget_keys(std::vector<Particles>& sets) {
  for (Particles& particles : sets) particles.settled_chunks = 0;
}

void place_particles(const Placement& agreed, long step, const Continuum& continuum) {
  const Region region("place_particles");
  if (agreed.someone_left) {
    std::vector<Particles>& sets = continuum.sets;
    const std::vector<int> first_row = migrate_particles(continuum.grid, sets);
    for (std::size_t s = 0; s < sets.size(); ++s)
      locate_newcomers(continuum.grid, sets[s], first_row[s]);
  }
  if (agreed.new_tile) make_active({}, continuum);
  sort_sets(step, continuum);
}

void activate_reached_tiles(
    const std::vector<int>& reached, long step, const Continuum& continuum
) {
  const Region region("activate_reached_tiles");
  make_active(tell_owners(continuum.grid, reached), continuum);
  sort_sets(step, continuum);
}

void give_parcels(const std::vector<int>& owner, long step, const Continuum& continuum) {
  const Region region("give_parcels");
  set_owners(owner, continuum.grid);
  // No tile is active in the new partition: everybody is looked for afresh.
  activate_tiles(continuum.grid, {});
  forget_keys(continuum.sets);
  locate_particles(continuum);
  place_particles({true, true}, step, continuum);
}

}  // namespace barreno
