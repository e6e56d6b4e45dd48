// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/read_checkpoint.hpp"

#include "base/gather.hpp"
#include "base/rank_work.hpp"
#include "base/region.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/own_rows.hpp"
#include "checkpoint/shared_file.hpp"
#include "grid/partition.hpp"
#include "grid/tiles.hpp"
#include "state/balance.hpp"
#include "step/order/remove_lost.hpp"

#include <algorithm>
#include <numeric>

namespace barreno {
namespace {

Vector position_of(const Particles& particles, const double* values) {
  Vector x{};
  std::copy_n(values, static_cast<std::size_t>(particles.position.components), x.data());
  return x;
}

/// The rows of a material that belong to this rank, ascending. Collective.
std::vector<std::size_t> own_rows(
    const State& state, const Particles& particles, const SharedFile& shared, const Hdf5File& file
) {
  const Comm& comm = *state.grid.comm;
  const std::string group = particle_group(particles);
  const auto counts = shared.read<long long>(group + "rank_counts");
  if (counts.size() == static_cast<std::size_t>(comm.getSize())) {
    const auto begin = std::accumulate(counts.begin(), counts.begin() + comm.getRank(), 0LL);
    std::vector<std::size_t> rows(
        static_cast<std::size_t>(counts[static_cast<std::size_t>(comm.getRank())])
    );
    std::iota(rows.begin(), rows.end(), static_cast<std::size_t>(begin));
    return rows;
  }
  return rows_by_owner(comm, file, group + "position", [&](const double* values) {
    const Vector x = position_of(particles, values);
    // One that has just left the grid is counted and removed by whoever has it.
    return state.grid.holds(x) ? owner_of(state.grid, x) : 0;
  });
}

void read_particles(
    const std::vector<std::size_t>& rows, const Hdf5File& file, Particles& particles
) {
  const std::string group = particle_group(particles);
  reserve(particles, static_cast<int>(rows.size()));
  particles.count = static_cast<int>(rows.size());
  particles.sorted = false;
  for (int p = 0; p < particles.count; ++p) mark_unplaced(particles, p);
  for_own_rows<long long>(rows, file, group + "removal", [&](int p, const long long* cause) {
    particles.fault(p) = fault_of_cause(static_cast<int>(*cause));
  });
  for_own_rows<long long>(rows, file, group + "id", [&](int p, const long long* id) {
    particles.id(p) = static_cast<ParticleId>(*id);
  });
  for_own_rows<long long>(rows, file, group + "body", [&](int p, const long long* body) {
    particles.body(p) = static_cast<int>(*body);
  });
  particles.for_each_field([&](Field& field) {
    if (field.components == 0) return;
    for_own_rows<double>(rows, file, group + field.name, [&](int p, const double* values) {
      for (int c = 0; c < field.components; ++c) field(p, c) = values[c];
    });
  });
}

/// Particles in each tile of the box, each rank counting its part of the rows. Collective.
std::vector<double> count_particles(const State& state, const Hdf5File& file) {
  const Comm& comm = *state.grid.comm;
  std::vector<double> counts(state.grid.owner.size(), 0.0);
  RankWork work(comm);
  work.run([&] {
    for (const Particles& particles : state.particles) {
      const std::string name = particle_group(particles) + "position";
      for_part_of_rows<double>(comm, file, name, [&](std::size_t, const double* values) {
        const Vector x = position_of(particles, values);
        if (!state.grid.holds(x)) return;
        counts[static_cast<std::size_t>(cell_of(state.grid, x).box_tile)] += 1.0;
      });
    }
  });
  work.agree();
  sum_over_ranks(comm, counts);  // whole numbers: in any order the same
  return counts;
}

/// Tiles as the ranks had them, or shared by the particles that are in them. Collective.
void share_tiles(const SharedFile& shared, const Hdf5File& file, bool same_ranks, State& state) {
  Grid& grid = state.grid;
  if (same_ranks) {
    const auto owner = shared.read<long long>("grid/owner");
    set_owners({owner.begin(), owner.end()}, grid);
    return;
  }
  const std::vector<double> counts = count_particles(state, file);
  std::vector<TileCost> costs(counts.size());
  for (std::size_t t = 0; t < counts.size(); ++t) costs[t].particles = counts[t];
  set_owners(bisect_tiles(grid.tiles, costs, grid.comm->getSize()), grid);
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
  state.stable_step = file.read<double>("run/stable_step").at(0);
}

}  // namespace

void read_checkpoint(const Checkpoint& checkpoint, State& state) {
  const Region region("read_checkpoint");
  const Comm& comm = *state.grid.comm;
  const SharedFile file(comm, checkpoint.open);
  const auto wrote = static_cast<int>(checkpoint.numbers.at("ranks").at(0));
  const bool same_ranks = wrote == comm.getSize();
  read_sums(file, state);
  share_tiles(file, *checkpoint.open, same_ranks, state);
  RankWork work(comm);
  for (Particles& particles : state.particles) {
    const std::vector<std::size_t> rows = own_rows(state, particles, file, *checkpoint.open);
    work.run([&] { read_particles(rows, *checkpoint.open, particles); });
  }
  work.agree();
  for_each_number(state, [&](const char* name, auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(checkpoint.numbers.at(name).at(0));
  });
  const std::vector<double>& volumes = checkpoint.numbers.at("cavities");
  for (std::size_t l = 0; l < state.cavities.size(); ++l) state.cavities[l].volume = volumes[l];
}

}  // namespace barreno
