// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/write_checkpoint.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/region.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/seal.hpp"
#include "state/balance.hpp"

#include <array>
#include <barreno/input/units.hpp>
#include <cstring>
#include <memory>

namespace barreno {
namespace {

namespace fs = std::filesystem;

Hdf5Table<double> one_column(std::vector<double> values) {
  const std::size_t rows = values.size();
  return {rows, 1, std::move(values)};
}

Hdf5Table<long long> one_column(std::vector<long long> values) {
  const std::size_t rows = values.size();
  return {rows, 1, std::move(values)};
}

/// Rows of a view of ids or bytes.
template <class View>
std::vector<long long> whole_numbers(const View& view, int count) {
  std::vector<long long> values(static_cast<std::size_t>(count));
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = static_cast<long long>(view(p));
  return values;
}

/// Row after row, where the field has component after component.
std::vector<double> rows_of(const Field& field, int count) {
  const auto columns = static_cast<std::size_t>(field.components);
  std::vector<double> values(static_cast<std::size_t>(count) * columns);
  for (int c = 0; c < field.components; ++c) {
    double* value = values.data() + c;
    for (int p = 0; p < count; ++p, value += columns) *value = field(p, c);
  }
  return values;
}

/// One material: ids, bodies and every field of the one list, with its unit.
void write_particles(
    const Comm& comm, const Particles& particles, RootWork& work, std::unique_ptr<Hdf5File>& file
) {
  const std::string group = "particles/" + std::to_string(particles.material) + "/";
  const auto put = [&](const char* name, const std::vector<long long>& mine) {
    auto all = gather_to_root(comm, mine);
    work.run([&] { file->write(group + name, one_column(std::move(all))); });
  };
  put("rank_counts", {particles.count});
  put("id", whole_numbers(particles.id, particles.count));
  put("body", whole_numbers(particles.body, particles.count));
  particles.for_each_field([&](const Field& field) {
    if (field.components == 0) return;
    Hdf5Table<double> table;
    table.columns = static_cast<std::size_t>(field.components);
    table.values = gather_to_root(comm, rows_of(field, particles.count));
    table.rows = table.values.size() / table.columns;
    work.run([&] { file->write(group + field.name, table, input::si_unit_of(field.dimension)); });
  });
}

/// Of all ranks: whole sums have no order.
Hdf5Table<long long> whole_table(const Comm& comm, std::vector<WholeSum> sums) {
  sum_over_ranks(comm, sums);
  Hdf5Table<long long> table{sums.size(), WholeSum::parts, {}};
  for (WholeSum& sum : sums) {
    sum.carry();
    table.values.insert(table.values.end(), sum.part, sum.part + WholeSum::parts);
  }
  return table;
}

std::vector<WholeSum> impulses_of(const State& state) {
  std::vector<WholeSum> impulses;
  for (const Reaction& reaction : state.reactions)
    impulses.insert(impulses.end(), reaction.impulse.begin(), reaction.impulse.end());
  return impulses;
}

void write_sums(
    const Comm& comm, const State& state, RootWork& work, std::unique_ptr<Hdf5File>& file
) {
  const Hdf5Table<long long> terms = whole_table(comm, terms_of(state.ledger));
  const Hdf5Table<long long> impulses = whole_table(comm, impulses_of(state));
  std::vector<double> steps{state.particle_steps, state.skipped_steps};
  sum_over_ranks(comm, steps);
  std::array<double, 1> stable{state.stable_step};
  min_over_ranks(comm, stable);
  work.run([&] {
    file->write("ledger/terms", terms);
    file->write("ledger/reactions", impulses);
    file->write("ledger/particle_steps", one_column(steps), "");
    file->write("run/stable_step", one_column(std::vector<double>{stable[0]}), "s");
  });
}

void write_numbers(const RunNumbers& numbers, const std::string& group, Hdf5File& file) {
  for (const auto& [name, values] : numbers) file.write(group + name, one_column(values), "");
}

RunNumbers numbers_of(const State& state) {
  RunNumbers numbers;
  for_each_number(state, [&](const char* name, const auto& value) {
    numbers[name] = {static_cast<double>(value)};
  });
  numbers["cavities"] = state.cavities;
  return numbers;
}

/// Reads all tables, which compares their checksums with what is in the file.
void read_back(const fs::path& path) {
  const Region region("read_checkpoint_back");
  const Hdf5File file(path, Hdf5File::Mode::read);
  for (const std::string group : {"run", "ledger", "output", "grid"})
    for (const std::string& name : file.names(group)) {
      std::string table = group;
      table += "/" + name;
      file.read(table);
    }
  file.read_text("deck");
  for (const std::string& material : file.names("particles"))
    for (const std::string& field : file.names("particles/" + material)) {
      std::string table = "particles/" + material;
      table += "/" + field;
      file.read(table);
    }
}

void refuse_full_disk(const fs::path& folder, double bytes) {
  constexpr double spare = 1.1;
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (error || static_cast<double>(space.available) > spare * bytes) return;
  throw FileError(
      "cannot write a checkpoint of " + std::to_string(static_cast<long long>(bytes * 1e-6) + 1) +
      " MB into '" + folder.string() + "' (the disk has " +
      std::to_string(space.available / 1000000) +
      " MB left); free the disk or give another place with --out."
  );
}

/// State fields of all ranks in bytes; scratch is not written.
double estimate(const State& state) {
  double doubles = 0.0;
  for (const Particles& particles : state.particles) {
    particles.for_each_field([&](const Field& field) {
      doubles += static_cast<double>(field.components) * particles.count;
    });
    doubles += 2.0 * particles.count;
  }
  std::array<double, 1> sum{doubles};
  sum_over_ranks(*state.grid.comm, sum);
  return 8.0 * sum[0];
}

void keep_previous(const fs::path& folder, const fs::path& aside) {
  std::error_code error;
  if (fs::exists(folder / checkpoint_name))
    fs::rename(folder / checkpoint_name, folder / previous_checkpoint_name, error);
  if (!error) fs::rename(aside, folder / checkpoint_name, error);
  if (error)
    throw FileError(
        "cannot name the checkpoint in '" + folder.string() + "' (" + error.message() +
        "); check the folder's permissions."
    );
  sync_folder(folder);
}

}  // namespace

void write_checkpoint(
    const fs::path& folder,
    const std::string& deck_text,
    const RunNumbers& output,
    const State& state
) {
  const Region region("write_checkpoint");
  const Comm& comm = *state.grid.comm;
  const fs::path aside = folder / (std::string(checkpoint_name) + ".tmp");
  const double bytes = estimate(state);
  RootWork work(comm);
  std::unique_ptr<Hdf5File> file;
  work.run([&] {
    refuse_full_disk(folder, bytes);
    file = std::make_unique<Hdf5File>(aside, Hdf5File::Mode::create);
    file->write("deck", deck_text);
    file->write("run/version", one_column(std::vector<double>{checkpoint_version}), "");
    file->write("run/ranks", one_column(std::vector<double>{1.0 * comm.getSize()}), "");
    write_numbers(numbers_of(state), "run/", *file);
    write_numbers(output, "output/", *file);
    file->write(
        "grid/owner",
        one_column(std::vector<long long>(state.grid.owner.begin(), state.grid.owner.end()))
    );
  });
  write_sums(comm, state, work, file);
  for (const Particles& particles : state.particles) write_particles(comm, particles, work, file);
  work.run([&] {
    file->close();
    read_back(aside);
    seal_checkpoint(aside);
    keep_previous(folder, aside);
  });
  file.reset();
  try {
    work.agree();
  } catch (const FileError&) {
    std::error_code ignored;
    if (is_root(comm)) fs::remove(aside, ignored);
    throw;
  }
}

}  // namespace barreno
