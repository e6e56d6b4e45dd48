// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/read_checkpoint.hpp"

#include "base/gather.hpp"
#include "base/region.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/shared_file.hpp"
#include "grid/partition.hpp"
#include "grid/tiles.hpp"
#include "state/balance.hpp"
#include "step/order/remove_lost.hpp"

#include <algorithm>
#include <numeric>

namespace barreno {
namespace {

/// visit(r, x) for the position of every particle of a material.
template <class Visitor>
void for_each_position(
    const State& state, const Particles& particles, const SharedFile& file, Visitor&& visit
) {
  const auto columns = static_cast<std::size_t>(particles.position.components);
  file.for_each_row<double>(
      particle_group(particles) + "position",
      [&](std::size_t row, const double* values) {
        Vector x{};
        std::copy_n(values, columns, x.data());
        visit(row, x, state.grid.holds(x));
      }
  );
}

/// The rows of a material that belong to this rank, ascending.
std::vector<std::size_t> own_rows(
    const State& state, const Particles& particles, const SharedFile& file, bool same_ranks
) {
  const Comm& comm = *state.grid.comm;
  const auto rank = static_cast<std::size_t>(comm.getRank());
  std::vector<std::size_t> rows;
  if (same_ranks) {
    const auto counts = file.read<long long>(particle_group(particles) + "rank_counts");
    const auto begin = std::accumulate(counts.begin(), counts.begin() + comm.getRank(), 0LL);
    rows.resize(static_cast<std::size_t>(counts[rank]));
    std::iota(rows.begin(), rows.end(), static_cast<std::size_t>(begin));
    return rows;
  }
  for_each_position(state, particles, file, [&](std::size_t row, const Vector& x, bool inside) {
    // One that has just left the grid is counted and removed by whoever has it.
    const int owner = inside ? owner_of(state.grid, x) : 0;
    if (owner == comm.getRank()) rows.push_back(row);
  });
  return rows;
}

/// visit(p, values) for the rows of a table that become this rank's particles p.
template <class T, class Visitor>
void for_own_rows(
    const std::vector<std::size_t>& rows,
    const SharedFile& file,
    const std::string& name,
    Visitor&& visit
) {
  std::size_t p = 0;
  file.for_each_row<T>(name, [&](std::size_t row, const T* values) {
    if (p < rows.size() && rows[p] == row) visit(static_cast<int>(p++), values);
  });
}

void read_particles(
    const std::vector<std::size_t>& rows, const SharedFile& file, Particles& particles
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

/// Tiles as the ranks had them, or shared by the particles that are in them.
void share_tiles(const SharedFile& file, bool same_ranks, State& state) {
  Grid& grid = state.grid;
  if (same_ranks) {
    const auto owner = file.read<long long>("grid/owner");
    set_owners({owner.begin(), owner.end()}, grid);
    return;
  }
  std::vector<TileCost> counts(grid.owner.size());
  for (const Particles& particles : state.particles)
    for_each_position(state, particles, file, [&](std::size_t, const Vector& x, bool inside) {
      if (inside) counts[static_cast<std::size_t>(cell_of(grid, x).box_tile)].particles += 1.0;
    });
  set_owners(bisect_tiles(grid.tiles, counts, grid.comm->getSize()), grid);
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
  share_tiles(file, same_ranks, state);
  for (Particles& particles : state.particles)
    read_particles(own_rows(state, particles, file, same_ranks), file, particles);
  for_each_number(state, [&](const char* name, auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(checkpoint.numbers.at(name).at(0));
  });
  const std::vector<double>& volumes = checkpoint.numbers.at("cavities");
  for (std::size_t l = 0; l < state.cavities.size(); ++l) state.cavities[l].volume = volumes[l];
}

}  // namespace barreno
