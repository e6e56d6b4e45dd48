// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/read_checkpoint.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/region.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/seal.hpp"
#include "checkpoint/shared_file.hpp"
#include "checkpoint/write_checkpoint.hpp"
#include "grid/partition.hpp"
#include "state/balance.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace barreno {
namespace {

namespace fs = std::filesystem;

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
  for_each_position(state, particles, file, [&](std::size_t row, const Vector& x, bool held) {
    // One that has just left the grid is counted and removed by whoever has it.
    const int owner = held ? owner_of(state.grid, x) : 0;
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
  for (int p = 0; p < particles.count; ++p) put_unplaced(particles, p);
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
    grid.owner.assign(owner.begin(), owner.end());
    return;
  }
  std::vector<TileCost> counts(grid.owner.size());
  for (const Particles& particles : state.particles)
    for_each_position(state, particles, file, [&](std::size_t, const Vector& x, bool held) {
      if (held) counts[static_cast<std::size_t>(cell_of(grid, x).tile)].particles += 1.0;
    });
  grid.owner = bisect_tiles(grid.tiles, counts, grid.comm->getSize());
}

/// Rank 0 takes what all have given.
std::vector<WholeSum> root_part(const Comm& comm, const std::vector<long long>& values) {
  constexpr std::size_t columns = WholeSum::parts;
  std::vector<WholeSum> sums(values.size() / columns);
  if (!is_root(comm)) return sums;
  for (std::size_t i = 0; i < values.size(); ++i) sums[i / columns].part[i % columns] = values[i];
  return sums;
}

void read_sums(const SharedFile& file, State& state) {
  const Comm& comm = *state.grid.comm;
  put_terms(root_part(comm, file.read<long long>("ledger/terms")), state.ledger);
  const std::vector<WholeSum> impulses = root_part(comm, file.read<long long>("ledger/reactions"));
  auto next = impulses.begin();
  for (Reaction& reaction : state.reactions)
    for (WholeSum& sum : reaction.impulse) sum = *next++;
  const auto steps = file.read<double>("ledger/particle_steps");
  state.particle_steps = is_root(comm) ? steps[0] : 0.0;
  state.skipped_steps = is_root(comm) ? steps[1] : 0.0;
  state.stable_step = file.read<double>("run/stable_step").at(0);
}

/// All tables of a group.
RunNumbers read_numbers(const Hdf5File& file, const std::string& group) {
  RunNumbers numbers;
  for (const std::string& name : file.names(group))
    numbers[name] = file.read(std::string(group).append("/").append(name)).values;
  return numbers;
}

/// Whether a file is a whole checkpoint of this version; why not, if it is not.
std::string fault_of(const fs::path& path, Checkpoint& found) {
  std::string fault = broken_seal(path);
  if (!fault.empty()) return fault;
  try {
    const Hdf5File file(path, Hdf5File::Mode::read);
    const int version = static_cast<int>(file.read("run/version").values.at(0));
    if (version != checkpoint_version)
      return "it has version " + std::to_string(version) + ", this program reads " +
             std::to_string(checkpoint_version);
    found.deck_text = file.read_text("deck");
    found.numbers = read_numbers(file, "run");
    found.output = read_numbers(file, "output");
  } catch (const FileError& error) {
    return error.what();
  }
  found.file = path;
  return {};
}

Checkpoint find_on_root(const fs::path& folder) {
  Checkpoint found;
  std::string faults;
  for (const char* name : {checkpoint_name, previous_checkpoint_name}) {
    const fs::path path = folder / name;
    if (!fs::exists(path)) continue;
    const std::string fault = fault_of(path, found);
    if (fault.empty()) return found;
    faults += (faults.empty() ? "" : "; ") + std::string(name) + ": " + fault;
    found.notes.push_back(std::string(name) + " is passed over: " + fault + ".");
  }
  throw FileError(
      "cannot resume from '" + folder.string() + "' (" +
      (faults.empty() ? "it holds no checkpoint.h5" : faults) +
      "); name the folder of a run, or start it again with barreno run."
  );
}

RunNumbers share(const Comm& comm, const RunNumbers& mine) {
  std::ostringstream names;
  std::vector<double> values;
  for (const auto& [name, numbers] : mine) {
    names << name << '\n' << numbers.size() << '\n';
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  std::istringstream shared(broadcast_from_root(comm, names.str()));
  RunNumbers all;
  std::size_t total = 0;
  std::vector<std::pair<std::string, std::size_t>> entries;
  std::string name;
  while (std::getline(shared, name)) {
    std::string size;
    std::getline(shared, size);
    entries.emplace_back(name, std::stoul(size));
    total += entries.back().second;
  }
  values.resize(total);
  if (total > 0) Teuchos::broadcast<int, double>(comm, 0, static_cast<int>(total), values.data());
  auto next = values.begin();
  for (const auto& [entry, size] : entries) {
    all[entry].assign(next, next + static_cast<std::ptrdiff_t>(size));
    next += static_cast<std::ptrdiff_t>(size);
  }
  return all;
}

std::string trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos ? "an empty line" : line.substr(begin);
}

/// End times may differ, and the name that a comment gives the deck.
bool may_differ(const std::string& a, const std::string& b) {
  for (const char* mark : {"<!-- ", "name=\"End Time\""})
    if (a.find(mark) != std::string::npos && b.find(mark) != std::string::npos) return true;
  return false;
}

}  // namespace

Checkpoint find_checkpoint(const Comm& comm, const fs::path& folder) {
  Checkpoint found;
  RootWork work(comm);
  work.run([&] { found = find_on_root(folder); });
  work.agree();
  found.file = broadcast_from_root(comm, found.file.string());
  found.deck_text = broadcast_from_root(comm, found.deck_text);
  found.numbers = share(comm, found.numbers);
  found.output = share(comm, found.output);
  return found;
}

void read_checkpoint(const Checkpoint& checkpoint, State& state) {
  const Region region("read_checkpoint");
  const Comm& comm = *state.grid.comm;
  const SharedFile file(comm, checkpoint.file);
  const auto wrote = static_cast<int>(checkpoint.numbers.at("ranks").at(0));
  const bool same_ranks = wrote == comm.getSize();
  read_sums(file, state);
  share_tiles(file, same_ranks, state);
  for (Particles& particles : state.particles)
    read_particles(own_rows(state, particles, file, same_ranks), file, particles);
  for_each_number(state, [&](const char* name, auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(checkpoint.numbers.at(name).at(0));
  });
  state.cavities = checkpoint.numbers.at("cavities");
}

std::string deck_difference(const std::string& kept, const std::string& found) {
  std::istringstream one(kept), other(found);
  std::string a, b;
  for (int line = 1;; ++line) {
    const bool more = static_cast<bool>(std::getline(one, a));
    const bool other_more = static_cast<bool>(std::getline(other, b));
    if (!more && !other_more) return {};
    if (!more) a = "nothing";
    if (!other_more) b = "nothing";
    if (a == b || may_differ(a, b)) continue;
    return "line " + std::to_string(line) + ": " + trimmed(a) + " against " + trimmed(b);
  }
}

}  // namespace barreno
