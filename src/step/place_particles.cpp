// SPDX-License-Identifier: BSD-3-Clause
#include "step/place_particles.hpp"

#include "base/region.hpp"
#include "base/rows.hpp"
#include "grid/tiles.hpp"
#include "step/migrate_particles.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

void tally_removal(const Particles& particles, int p, RemovalCause cause, OwnLedger& ledger) {
  auto& tally = ledger.removed[static_cast<std::size_t>(cause)];
  const double m = particles.mass(p);
  const Vector v = vector_of(particles.velocity, p);
  tally.count += 1.0;
  tally.mass += m;
  ledger.mass -= m;
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  if (!std::isfinite(square)) return;
  tally.momentum += m * v[1];
  tally.kinetic += 0.5 * m * square;
  ledger.momentum -= m * v[1];
  ledger.kinetic -= 0.5 * m * square;
}

}  // namespace

int removal_cause(const Grid& grid, const Particles& particles, int p) {
  const Vector x = vector_of(particles.position, p);
  const Vector v = vector_of(particles.velocity, p);
  const double sum = x[0] + x[1] + x[2] + v[0] + v[1] + v[2];
  if (!std::isfinite(sum)) return static_cast<int>(RemovalCause::not_finite);
  switch (particles.fault(p)) {
    case Fault::failed:
      return static_cast<int>(RemovalCause::material_failure);
    case Fault::expanded:
      return static_cast<int>(RemovalCause::expanded);
    case Fault::inverted:
      return static_cast<int>(RemovalCause::inverted);
    case Fault::none:
      break;
  }
  if (!grid.holds(x)) return static_cast<int>(RemovalCause::left_grid);
  return -1;
}

Fault fault_of_cause(int cause) {
  if (cause == static_cast<int>(RemovalCause::material_failure)) return Fault::failed;
  if (cause == static_cast<int>(RemovalCause::expanded)) return Fault::expanded;
  if (cause == static_cast<int>(RemovalCause::inverted)) return Fault::inverted;
  return Fault::none;
}

namespace {

void remove_lost(const Grid& grid, Particles& particles, OwnLedger& ledger) {
  std::vector<char> keep(static_cast<std::size_t>(particles.count), 1);
  for (int p = 0; p < particles.count; ++p) {
    const int cause = removal_cause(grid, particles, p);
    if (cause < 0) continue;
    if (!particles.rigid) tally_removal(particles, p, static_cast<RemovalCause>(cause), ledger);
    keep[static_cast<std::size_t>(p)] = 0;
  }
  keep_rows(particles, keep);
}

/// What a look at every particle's cell has found.
struct Found {
  int outside = 0, moved = 0, new_tile = 0, left = 0;
};

/// Keys of a set's rows from their cells, without branches for the compiler to vectorise; rows
/// outside the grid or lost otherwise keep theirs. Of other ranks' tiles those are active that are
/// ghosts here; of others, further away, nothing is known.
template <unsigned D>
Found find_keys(const Grid& grid, const Particles& particles, int first_row) {
  constexpr int dimensions = D;
  double lower[D], upper[D];
  int tiles[D];
  const double* position[D];
  for (int d = 0; d < dimensions; ++d) {
    lower[d] = grid.lower[d];
    upper[d] = grid.upper[d];
    tiles[d] = grid.tiles[d];
    position[d] = &particles.position(0, d);
  }
  const double per_cell = 1.0 / grid.cell_size;
  const int bits = grid.patch.tile_bits;
  const int in_tile = grid.patch.tile_cells - 1;
  const int cells = grid.patch.cells;
  const int active = grid.active;
  const int count = particles.count;
  const int me = grid.comm->getRank();
  const int* const owner = grid.owner.data();
  const int* const directory = grid.directory.data();
  int* const keys = particles.key.data();
  const Fault* const faults = particles.fault.data();
  Found found;
  BARRENO_IVDEP
  for (int p = first_row; p < count; ++p) {
    const int old_key = keys[p];
    int lost = static_cast<int>(faults[p] != Fault::none);
    for (int d = 0; d < dimensions; ++d)
      lost |= static_cast<int>(!(position[d][p] >= lower[d])) |
              static_cast<int>(!(position[d][p] < upper[d]));
    int box = 0;
    int inside = 0;
    for (int d = dimensions - 1; d >= 0; --d) {
      const int cell = static_cast<int>(lost ? 0.0 : (position[d][p] - lower[d]) * per_cell);
      box = box * tiles[d] + (cell >> bits);
      inside = (inside << bits) + (cell & in_tile);
    }
    const int tile = directory[box];
    const int here = static_cast<int>(tile >= 0) & static_cast<int>(tile < active);
    const int mine = static_cast<int>(owner[box] == me);
    const int unknown = static_cast<int>(tile < 0);
    const int key = here ? tile * cells + inside : unplaced_key;
    found.outside |= lost;
    found.moved |= static_cast<int>(key != old_key);
    found.new_tile |= (1 - lost) & (1 - here) & (mine | unknown);
    found.left |= (1 - lost) & (1 - here) & (1 - mine);
    keys[p] = lost ? old_key : key;
  }
  return found;
}

Found find_keys(const Grid& grid, const Particles& particles, int first_row) {
  return grid.patch.dimensions == 3 ? find_keys<3>(grid, particles, first_row)
                                    : find_keys<2>(grid, particles, first_row);
}

/// Keys of a set's rows; false if one is outside the grid or lost otherwise.
bool find_keys(const Grid& grid, Particles& particles, Placement& placement) {
  if (particles.count == 0) return true;
  const Found found = find_keys(grid, particles, 0);
  placement.new_tile = placement.new_tile || found.new_tile != 0;
  placement.someone_left = placement.someone_left || found.left != 0;
  if (found.moved != 0) particles.sorted = false;
  return found.outside == 0;
}

std::vector<int> occupied_tiles(const State& state) {
  std::vector<char> holds(state.grid.owner.size(), 0);
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      holds[static_cast<std::size_t>(cell_of(state.grid, vector_of(particles.position, p)).tile)] =
          1;
  std::vector<int> tiles;
  for (std::size_t t = 0; t < holds.size(); ++t)
    if (holds[t]) tiles.push_back(static_cast<int>(t));
  return tiles;
}

/// Rows by key; within a cell by id, so that the order does not depend on how the rows are stored.
void sort_by_cell(const Grid& grid, Particles& particles) {
  const auto tiles = static_cast<std::size_t>(grid.active);
  const auto cells = static_cast<std::size_t>(grid.patch.cells);
  const std::size_t keys = tiles * cells;
  if (particles.cell_begin.extent(0) < keys + 1) {
    particles.cell_begin = ArrayView<int>("cell_begin", keys + keys / 4 + 1);
    particles.cell_end = ArrayView<int>("cell_end", keys + keys / 4 + 1);
  }
  if (particles.tile_begin.extent(0) < tiles + 1)
    particles.tile_begin = ArrayView<int>("tile_begin", tiles + tiles / 4 + 1);

  int* const begin = particles.cell_begin.data();
  int* const end = particles.cell_end.data();
  int* const order = particles.order.data();
  std::fill(begin, begin + keys + 1, 0);
  for (int p = 0; p < particles.count; ++p) ++begin[particles.key(p) + 1];
  for (std::size_t k = 0; k < keys; ++k) begin[k + 1] += begin[k];
  std::copy(begin, begin + keys, end);
  for (int p = 0; p < particles.count; ++p) {
    const int key = particles.key(p);
    int place = end[key]++;
    for (; place > begin[key] && particles.id(order[place - 1]) > particles.id(p); --place)
      order[place] = order[place - 1];
    order[place] = p;
  }
  for (std::size_t t = 0; t <= tiles; ++t) particles.tile_begin(t) = begin[t * cells];
  particles.sorted = true;
}

void locate_set(State& state, Particles& particles, Placement& placement) {
  if (find_keys(state.grid, particles, placement)) return;
  remove_lost(state.grid, particles, state.ledger);
  find_keys(state.grid, particles, placement);
}

/// Cells of the rows that have come, which are the last ones.
void locate_newcomers(const Grid& grid, const Particles& particles) {
  int first_row = particles.count;
  while (first_row > 0 && particles.key(first_row - 1) == unplaced_key) --first_row;
  find_keys(grid, particles, first_row);
}

}  // namespace

Placement locate_particles(const Scene& /*scene*/, State& state) {
  const Region region("locate_particles");
  const Stopwatch watch;
  Placement placement;
  for (Particles& particles : state.particles) locate_set(state, particles, placement);
  state.effort.tile_seconds += watch.seconds();
  return placement;
}

void place_particles(const Scene& scene, const Placement& agreed, State& state) {
  const Region region("place_particles");
  if (agreed.someone_left) {
    migrate_particles(state);
    for (const Particles& particles : state.particles) locate_newcomers(state.grid, particles);
  }
  if (agreed.new_tile) {
    activate_tiles(state.grid, occupied_tiles(state));
    locate_particles(scene, state);
    for (Particles& particles : state.particles) particles.sorted = false;
  }
  const Stopwatch watch;
  for (Particles& particles : state.particles) {
    if (particles.sorted) continue;
    sort_by_cell(state.grid, particles);
    if (state.clock.step % steps_per_permutation == 0) permute_rows(particles);
  }
  state.effort.tile_seconds += watch.seconds();
}

void give_tiles(const Scene& scene, const std::vector<int>& owner, State& state) {
  const Region region("give_tiles");
  state.grid.owner = owner;
  // No tile is active in the new partition: everybody is looked for afresh.
  activate_tiles(state.grid, {});
  locate_particles(scene, state);
  place_particles(scene, {true, true}, state);
}

}  // namespace barreno
