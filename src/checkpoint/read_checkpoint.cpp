// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/read_checkpoint.hpp"

#include "base/gather.hpp"
#include "base/rank_work.hpp"
#include "base/region.hpp"
#include "checkpoint/check_values.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/own_rows.hpp"
#include "checkpoint/read_particles.hpp"
#include "checkpoint/shared_file.hpp"
#include "grid/partition.hpp"
#include "grid/tiles.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <numeric>

namespace barreno {
namespace {

/// Of every material, the tile of level 0 that each row of this rank's equal part is in; -1:
/// outside the grid.
using PartTiles = std::vector<std::vector<int>>;

/// Collective. @throws FileError on every rank
PartTiles tiles_of_part(const State& state, const Hdf5File& file) {
  const Comm& comm = *state.grid.comm;
  PartTiles tiles;
  RankWork work(comm);
  work.run([&] {
    for (const Particles& particles : state.particles) {
      std::vector<int>& of_rows = tiles.emplace_back();
      const std::string name = particle_group(particles) + "position";
      for_part_of_rows<double>(comm, file, name, [&](std::size_t, const double* values) {
        Vector x{};
        std::copy_n(values, static_cast<std::size_t>(particles.position.components), x.data());
        of_rows.push_back(state.grid.holds(x) ? cell_of(state.grid, x).box_tile : -1);
      });
    }
  });
  work.agree();
  return tiles;
}

/// Particles of all ranks, by parcel. Collective.
std::vector<ParcelCost> count_in_parcels(const PartTiles& tiles, const Grid& grid) {
  std::vector<double> counts(grid.owner.size(), 0.0);
  for (const std::vector<int>& of_rows : tiles)
    for (const int tile : of_rows)
      if (tile >= 0) counts[static_cast<std::size_t>(grid.parcels.holding(tile))] += 1.0;
  sum_over_ranks(*grid.comm, counts);  // whole numbers: in any order the same
  std::vector<ParcelCost> costs(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) costs[i].particles = counts[i];
  return costs;
}

/// The rows of a material that this rank wrote, where there are as many ranks. Collective.
std::vector<std::size_t> written_rows(
    const Comm& comm, const SharedFile& shared, const Particles& particles
) {
  const auto counts = shared.read<long long>(particle_group(particles) + "rank_counts");
  const auto begin = std::accumulate(counts.begin(), counts.begin() + comm.getRank(), 0LL);
  std::vector<std::size_t> rows(
      static_cast<std::size_t>(counts[static_cast<std::size_t>(comm.getRank())])
  );
  std::iota(rows.begin(), rows.end(), static_cast<std::size_t>(begin));
  return rows;
}

/// The rows of a material in this rank's tiles. Collective.
std::vector<std::size_t> rows_in_tiles(
    const Grid& grid, const Hdf5File& file, const std::string& name, const std::vector<int>& tiles
) {
  const std::size_t rows = file.size_of(name).rows;
  const std::size_t begin = part_of_rows(*grid.comm, rows).begin;
  return rows_by_owner(*grid.comm, rows, [&](std::size_t row) {
    const int tile = tiles[row - begin];
    // One that has just left the grid is counted and removed by whoever has it.
    return tile >= 0 ? owner_of(grid, tile) : 0;
  });
}

/// Owners of parcels and rows of particles: as the ranks had them, or shared anew. Collective.
void read_rows(const KnownRun& run, const SharedFile& shared, State& state) {
  const Comm& comm = *state.grid.comm;
  const Hdf5File& file = *run.checkpoint.open;
  if (static_cast<int>(number_of(run.checkpoint.numbers, "ranks")) == comm.getSize()) {
    const auto owner = shared.read<long long>("grid/owner");
    set_owners({owner.begin(), owner.end()}, state.grid);
    for (Particles& particles : state.particles)
      read_particles(run, written_rows(comm, shared, particles), particles);
    return;
  }
  const PartTiles tiles = tiles_of_part(state, file);
  share_parcels(count_in_parcels(tiles, state.grid), state.grid);
  for (std::size_t m = 0; m < state.particles.size(); ++m) {
    Particles& particles = state.particles[m];
    const std::string name = particle_group(particles) + "position";
    read_particles(run, rows_in_tiles(state.grid, file, name, tiles[m]), particles);
  }
}

/// Rank 0 takes what all have given.
std::vector<ReproducibleSum> root_part(const Comm& comm, const std::vector<long long>& values) {
  constexpr std::size_t columns = ReproducibleSum::parts;
  std::vector<ReproducibleSum> sums(values.size() / columns);
  if (!is_root(comm)) return sums;
  for (std::size_t i = 0; i < values.size(); ++i) sums[i / columns].part[i % columns] = values[i];
  return sums;
}

void read_sums(const SharedFile& file, State& state) {
  const Comm& comm = *state.grid.comm;
  put_terms(root_part(comm, file.read<long long>("ledger/terms")), state.ledger);
  put_material_terms(root_part(comm, file.read<long long>("ledger/materials")), state.ledger);
  const std::vector<ReproducibleSum> impulses =
      root_part(comm, file.read<long long>("ledger/reactions"));
  auto next = impulses.begin();
  for (Reaction& reaction : state.reactions)
    for (ReproducibleSum& sum : reaction.impulse) sum = *next++;
  const auto steps = file.read<double>("ledger/particle_steps");
  state.particle_steps = is_root(comm) ? steps[0] : 0.0;
  state.skipped_steps = is_root(comm) ? steps[1] : 0.0;
  const auto shares = shares_of(file.read<double>("ledger/step_shares"));
  if (is_root(comm)) state.step_shares = shares;
  state.step_limits = step_limits_of(file.read<double>("ledger/step_limits"));
  state.stable_step = file.read<double>("run/stable_step").at(0);
  const auto of_sets = file.read<double>("ledger/stable_steps");
  for (std::size_t s = 0; s < of_sets.size(); ++s)
    if (of_sets[s] > 0.0) state.particles[s].stable_step = of_sets[s];  // 0: it allows any step
}

}  // namespace

void read_checkpoint(
    const Scene& scene, const std::vector<IdRange>& ids, const Checkpoint& checkpoint, State& state
) {
  const Region region("read_checkpoint");
  const SharedFile file(*state.grid.comm, checkpoint.open);
  read_sums(file, state);
  name_checkpoint(checkpoint, [&] {
    read_rows({scene, ids, checkpoint, state.grid, state.jet}, file, state);
  });
  for_each_number(state, [&](const char* name, auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(checkpoint.numbers.at(name).at(0));
  });
  if (has_tile_steps(state)) state.resumed_tile_steps = file.read<double>("grid/step_length");
  const std::vector<double>& volumes = checkpoint.numbers.at("cavities");
  for (std::size_t l = 0; l < state.cavities.size(); ++l) state.cavities[l].volume = volumes[l];
}

}  // namespace barreno
