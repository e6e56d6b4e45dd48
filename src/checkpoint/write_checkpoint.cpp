// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/write_checkpoint.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/rank_work.hpp"
#include "base/region.hpp"
#include "checkpoint/continued_tables.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/seal.hpp"
#include "checkpoint/write_rows.hpp"
#include "state/balance.hpp"
#include "state/last_tile_steps.hpp"
#include "step/order/remove_lost.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>
#include <array>
#include <barreno/input/units.hpp>
#include <cmath>
#include <fcntl.h>
#include <memory>
#include <sys/resource.h>
#include <system_error>
#include <thread>
#include <unistd.h>

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
auto whole_numbers(const View& view) {
  return [&view](std::size_t first, std::size_t count, long long* values) {
    for (std::size_t p = 0; p < count; ++p) values[p] = static_cast<long long>(view(first + p));
  };
}

/// Row after row, where the field has component after component; a few rows at a time, which the
/// first cache holds.
void pack_rows(const Field& field, std::size_t first, std::size_t count, double* values) {
  constexpr std::size_t few = 64;
  const auto columns = static_cast<std::size_t>(field.components);
  for (std::size_t begin = 0; begin < count; begin += few) {
    const std::size_t end = std::min(begin + few, count);
    for (std::size_t c = 0; c < columns; ++c)
      for (std::size_t p = begin; p < end; ++p)
        values[p * columns + c] = field.values(first + p, c);
  }
}

/// visit(table) for ids, bodies and every field of a material's one list, with its unit.
template <class Visitor>
void for_each_table(const Grid& grid, const Particles& particles, Visitor&& visit) {
  const std::string group = particle_group(particles);
  visit(SharedTable<long long>{group + "id", "", 1, whole_numbers(particles.id)});
  visit(SharedTable<long long>{group + "body", "", 1, whole_numbers(particles.body)});
  const RemovalRule rule(grid, particles);
  const auto cause = [&](std::size_t p) { return rule.cause_of(static_cast<int>(p)); };
  visit(SharedTable<long long>{group + "removal", "", 1, whole_numbers(cause)});
  particles.for_each_field([&](const Field& field) {
    if (field.components == 0) return;
    visit(SharedTable<double>{
        group + field.name,
        input::si_unit_of(field.dimension),
        static_cast<std::size_t>(field.components),
        [&](std::size_t begin, std::size_t count, double* values) {
          pack_rows(field, begin, count, values);
        }});
  });
}

template <class T>
unsigned long long lay_out(const SharedTable<T>& table, std::size_t rows, Hdf5File& file) {
  return file.lay_out<T>(table.name, rows, table.columns, table.unit);
}

/// Room for the tables of one material. @return where each of them begins
std::vector<long long> lay_out_particles(
    const Grid& grid,
    const Particles& particles,
    const std::vector<std::size_t>& first,
    Hdf5File& file
) {
  std::vector<long long> counts, places;
  for (std::size_t r = 1; r < first.size(); ++r)
    counts.push_back(static_cast<long long>(first[r] - first[r - 1]));
  file.write(particle_group(particles) + "rank_counts", one_column(std::move(counts)));
  for_each_table(grid, particles, [&](const auto& table) {
    places.push_back(static_cast<long long>(lay_out(table, first.back(), file)));
  });
  return places;
}

/// The same on every rank.
std::vector<long long> shared(const Comm& comm, std::vector<long long> values) {
  auto count = static_cast<int>(values.size());
  Teuchos::broadcast<int, int>(comm, 0, 1, &count);
  values.resize(static_cast<std::size_t>(count));
  if (count > 0) Teuchos::broadcast<int, long long>(comm, 0, count, values.data());
  return values;
}

/// Of all ranks; the order does not matter for reproducible sums.
Hdf5Table<long long> whole_table(const Comm& comm, std::vector<ReproducibleSum> sums) {
  sum_over_ranks(comm, sums);
  Hdf5Table<long long> table{sums.size(), ReproducibleSum::parts, {}};
  for (ReproducibleSum& sum : sums) {
    sum.carry();
    table.values.insert(table.values.end(), sum.part, sum.part + ReproducibleSum::parts);
  }
  return table;
}

std::vector<ReproducibleSum> impulses_of(const State& state) {
  std::vector<ReproducibleSum> impulses;
  for (const Reaction& reaction : state.reactions)
    impulses.insert(impulses.end(), reaction.impulse.begin(), reaction.impulse.end());
  return impulses;
}

/// Stable steps of all particles and of each set, without the first; 0: a set allows any step.
std::vector<double> steps_of_sets(const std::vector<double>& stable) {
  std::vector<double> steps(stable.begin() + 1, stable.end());
  for (double& step : steps) step = std::isfinite(step) ? step : 0.0;
  return steps;
}

void write_sums(
    const Comm& comm, const State& state, RootWork& work, std::unique_ptr<Hdf5File>& file
) {
  const Hdf5Table<long long> terms = whole_table(comm, terms_of(state.ledger));
  const Hdf5Table<long long> of_materials = whole_table(comm, material_terms_of(state.ledger));
  const Hdf5Table<long long> impulses = whole_table(comm, impulses_of(state));
  std::vector<double> steps{state.particle_steps, state.skipped_steps};
  sum_over_ranks(comm, steps);
  std::vector<double> shares = values_of(state.step_shares);
  sum_over_ranks(comm, shares);
  std::vector<double> stable{state.stable_step};
  for (const Particles& particles : state.particles) stable.push_back(particles.stable_step);
  min_over_ranks(comm, stable);
  work.run([&] {
    file->write("ledger/terms", terms);
    file->write("ledger/materials", of_materials);
    file->write("ledger/reactions", impulses);
    file->write("ledger/particle_steps", one_column(steps), "");
    file->write("ledger/step_shares", one_column(shares), "");
    file->write("ledger/step_limits", one_column(values_of(state.step_limits)), "");
    file->write("run/stable_step", one_column(std::vector<double>{stable[0]}), "s");
    file->write("ledger/stable_steps", one_column(steps_of_sets(stable)), "s");
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
  std::vector<double>& volumes = numbers["cavities"];
  for (const Cavity& cavity : state.cavities) volumes.push_back(cavity.volume);
  return numbers;
}

/// Reads the tables that rank 0 wrote, which compares their checksums with what is in the file.
void read_back(const fs::path& path) {
  const Hdf5File file(path, Hdf5File::Mode::read);
  const auto check = [&](const std::string& group, const std::string& name) {
    file.check(std::string(group).append("/").append(name));
  };
  for (const std::string group : {"run", "ledger", "output", "grid", "continued"})
    if (file.has(group))
      for (const std::string& name : file.names(group)) check(group, name);
  for (const char* text : {"deck", "continued_names"})
    if (file.has(text)) file.check(text);
  for (const std::string& material : file.names("particles"))
    check("particles/" + material, "rank_counts");
}

void refuse_full_disk(const fs::path& folder, double bytes) {
  constexpr double spare = 1.1;
  rlimit most{};
  if (getrlimit(RLIMIT_FSIZE, &most) == 0 && most.rlim_cur != RLIM_INFINITY &&
      static_cast<double>(most.rlim_cur) < spare * bytes)
    throw FileError(
        "cannot write a checkpoint of " + std::to_string(static_cast<long long>(bytes * 1e-6) + 1) +
        " MB into '" + folder.string() + "' (files here may have " +
        std::to_string(most.rlim_cur / 1000000) + " MB); raise the limit (ulimit -f)."
    );
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (error || static_cast<double>(space.available) > spare * bytes) return;
  throw FileError(
      "cannot write a checkpoint of " + std::to_string(static_cast<long long>(bytes * 1e-6) + 1) +
      " MB into '" + folder.string() + "' (the disk has " +
      std::to_string(space.available / 1000000) +
      " MB left); free disk space or choose another folder with --out."
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

/// Frees the blocks of a file that has lost its name while the run goes on: some disks take as long
/// for that as for writing them.
void close_aside(int file) {
  if (file < 0) return;
  try {
    std::thread([file] { close(file); }).detach();
  } catch (const std::system_error&) {  // no thread to be had
    close(file);
  }
}

/// Which rows of each material are whose, and where its tables begin in the file.
struct CheckpointLayout {
  std::vector<std::vector<std::size_t>> first;  ///< by material; first_rows()
  std::vector<long long> places;                ///< by material, then for_each_table()
};

/// What rank 0 alone has or knows.
void write_run(
    const std::string& deck_text,
    const RunNumbers& output,
    const State& state,
    const Continued& continued,
    std::vector<double> tile_steps,
    Hdf5File& file
) {
  const Grid& grid = state.grid;
  file.write("deck", deck_text);
  file.write("run/version", one_column(std::vector<double>{checkpoint_version}), "");
  file.write("run/ranks", one_column(std::vector<double>{1.0 * grid.comm->getSize()}), "");
  write_numbers(numbers_of(state), "run/", file);
  write_numbers(output, "output/", file);
  write_numbers(numbers_of(continued), "continued/", file);
  if (continued.on()) file.write("continued_names", names_of(continued));
  file.write(
      "grid/owner", one_column(std::vector<long long>(grid.owner.begin(), grid.owner.end()))
  );
  if (!tile_steps.empty()) file.write("grid/step_length", one_column(std::move(tile_steps)), "s");
}

/// Rank 0 writes the file but for the rows of particles. Collective. @throws FileError on every
/// rank
CheckpointLayout lay_out(
    const fs::path& aside,
    const std::string& deck_text,
    const RunNumbers& output,
    const State& state,
    const Continued& continued
) {
  const Comm& comm = *state.grid.comm;
  const double bytes = estimate(state);
  CheckpointLayout layout;
  for (const Particles& particles : state.particles)
    layout.first.push_back(first_rows(comm, particles.count));
  std::vector<double> tile_steps;
  if (has_tile_steps(state)) tile_steps = last_tile_steps(state);
  RootWork work(comm);
  std::unique_ptr<Hdf5File> file;
  work.run([&] {
    refuse_full_disk(aside.parent_path(), bytes);
    file = std::make_unique<Hdf5File>(aside, Hdf5File::Mode::create);
    write_run(deck_text, output, state, continued, std::move(tile_steps), *file);
  });
  write_sums(comm, state, work, file);
  work.run([&] {
    for (std::size_t m = 0; m < state.particles.size(); ++m)
      for (const long long place :
           lay_out_particles(state.grid, state.particles[m], layout.first[m], *file))
        layout.places.push_back(place);
    file->close();
  });
  file.reset();
  work.agree();
  layout.places = shared(comm, std::move(layout.places));
  return layout;
}

/// Every rank writes its rows, reads them back and brings them to the disk. Collective.
/// @throws FileError on every rank
void write_particles(const fs::path& aside, const CheckpointLayout& layout, const State& state) {
  const Comm& comm = *state.grid.comm;
  const auto rank = static_cast<std::size_t>(comm.getRank());
  RankWork work(comm);
  work.run([&] {
    RowFile rows(aside);
    auto place = layout.places.begin();
    for (std::size_t m = 0; m < state.particles.size(); ++m) {
      const RowSpan own{layout.first[m][rank], layout.first[m][rank + 1]};
      for_each_table(state.grid, state.particles[m], [&](const auto& table) {
        write_rows(table, static_cast<unsigned long long>(*place++), own, rows);
      });
    }
    const Region region("read_checkpoint_back");
    rows.read_back();
    if (is_root(comm)) read_back(aside);
    rows.sync();
  });
  work.agree();
}

}  // namespace

void rename_checkpoint(const fs::path& folder) {
  const fs::path aside = folder / checkpoint_temporary_name;
  const fs::path previous = folder / previous_checkpoint_name;
  const int replaced =
      open(previous.c_str(), O_RDONLY);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  std::error_code error;
  if (fs::exists(folder / checkpoint_name)) fs::rename(folder / checkpoint_name, previous, error);
  if (!error) fs::rename(aside, folder / checkpoint_name, error);
  if (!error) sync_folder(folder);
  close_aside(replaced);
  if (error)
    throw FileError(
        "cannot rename the temporary file in '" + folder.string() + "' (" + error.message() +
        "); check the folder's permissions."
    );
}

void write_checkpoint(
    const fs::path& folder,
    const std::string& deck_text,
    const RunNumbers& output,
    const State& state,
    const Continued& continued
) {
  const Region region("write_checkpoint");
  const Comm& comm = *state.grid.comm;
  const fs::path aside = folder / checkpoint_temporary_name;
  try {
    const CheckpointLayout layout = lay_out(aside, deck_text, output, state, continued);
    write_particles(aside, layout, state);
    seal_checkpoint(comm, aside);
    RootWork work(comm);
    work.run([&] { rename_checkpoint(folder); });
    work.agree();
  } catch (const FileError&) {
    std::error_code ignored;
    if (is_root(comm)) fs::remove(aside, ignored);
    throw;
  }
}

}  // namespace barreno
