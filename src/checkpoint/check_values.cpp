// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/check_values.hpp"

#include "base/error.hpp"
#include "base/region.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/first_fault.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

std::string shape_text(const Hdf5Size& size) {
  return std::to_string(size.rows) + " x " + std::to_string(size.columns);
}

/// @param reason  ends the sentence: where the wanted size comes from
void expect_size(
    const Hdf5File& file,
    const std::string& name,
    const Hdf5Size& wanted,
    const std::string& reason = {}
) {
  const Hdf5Size found = file.size_of(name);
  if (found.rows != wanted.rows || found.columns != wanted.columns)
    throw WrongTable{
        name + " is " + shape_text(found) + " instead of " + shape_text(wanted) + reason, 0};
}

/// visit(row, values) chunk by chunk, for tables that rank 0 alone looks at.
template <class T, class Visitor>
void for_each_row(const Hdf5File& file, const std::string& name, Visitor&& visit) {
  const Hdf5Size all = file.size_of(name);
  const std::size_t most = rows_of_chunk(all.rows, all.columns);
  for (std::size_t first = 0; first < all.rows; first += most) {
    const std::size_t count = std::min(most, all.rows - first);
    const std::vector<T> values = file.read_rows<T>(name, first, count);
    for (std::size_t r = 0; r < count; ++r) visit(first + r, values.data() + r * all.columns);
  }
}

/// visit(row, value) for a table of one column and so many rows.
template <class T, class Visitor>
void for_each_value(
    const Hdf5File& file, const std::string& name, std::size_t rows, Visitor&& visit
) {
  expect_size(file, name, {rows, 1});
  for_each_row<T>(file, name, [&](std::size_t row, const T* value) { visit(row, *value); });
}

void check_owners(const Hdf5File& file, const State& state, long long ranks) {
  const std::string name = "grid/owner";
  for_each_value<long long>(
      file,
      name,
      state.grid.owner.size(),
      [&](std::size_t row, long long owner) {
        if (owner < 0 || owner >= ranks) refuse_value(name, row, static_cast<double>(owner));
      }
  );
}

void check_tile_steps(const Hdf5File& file, const BoxTiles& box) {
  const std::string name = "grid/step_length";
  const auto tiles = static_cast<std::size_t>(box.first_id[box.levels]);
  for_each_value<double>(file, name, tiles, [&](std::size_t row, double step) {
    if (!(step >= 0.0 && std::isfinite(step))) refuse_value(name, row, step);
  });
}

/// Whole sums in their one form, far from what a part can hold.
void check_reproducible_sums(const Hdf5File& file, const std::string& name, std::size_t rows) {
  constexpr long long part = 1LL << ReproducibleSum::bits_per_part;
  constexpr long long max_leading_part = 1LL << 52U;
  expect_size(file, name, {rows, ReproducibleSum::parts});
  for_each_row<long long>(file, name, [&](std::size_t row, const long long* parts) {
    bool fine = parts[0] > -max_leading_part && parts[0] < max_leading_part;
    for (int i = 1; i < ReproducibleSum::parts; ++i)
      fine = fine && parts[i] >= 0 && parts[i] < part;
    if (!fine) throw WrongTable{name + " holds no sum in row " + std::to_string(row), row};
  });
}

void check_sums(const Hdf5File& file, const State& state) {
  check_reproducible_sums(file, "ledger/terms", terms_of(state.ledger).size());
  check_reproducible_sums(file, "ledger/materials", material_terms_of(state.ledger).size());
  check_reproducible_sums(file, "ledger/reactions", 3 * state.reactions.size());
  const auto check_counts = [&](const std::string& name, std::size_t rows) {
    for_each_value<double>(file, name, rows, [&](std::size_t row, double steps) {
      if (!(steps >= 0.0 && std::isfinite(steps))) refuse_value(name, row, steps);
    });
  };
  check_counts("ledger/particle_steps", 2);
  check_counts("ledger/step_shares", values_of(state.step_shares).size());
  check_counts("ledger/step_limits", values_of(state.step_limits).size());
  check_counts("ledger/stable_steps", state.particles.size());
}

void check_counts(const Hdf5File& file, const std::string& name, long long ranks, std::size_t all) {
  const auto most = static_cast<long long>(all);
  long long sum = 0;
  for_each_value<long long>(
      file,
      name,
      static_cast<std::size_t>(ranks),
      [&](std::size_t row, long long count) {
        if (count < 0 || count > most - sum) refuse_value(name, row, static_cast<double>(count));
        sum += count;
      }
  );
  if (sum != most)
    throw WrongTable{
        name + " adds up to " + std::to_string(sum) + " instead of " + std::to_string(all), 0};
}

/// Every table of a material has its size, and what rank 0 alone reads of it can be.
void check_sizes(const Particles& particles, const Hdf5File& file, long long ranks) {
  const std::string group = particle_group(particles);
  const std::string ids = group + "id";
  const std::size_t rows = file.size_of(ids).rows;
  const std::string reason = ", as many rows as " + ids;
  for (const char* name : {"id", "body", "removal"})
    expect_size(file, group + name, {rows, 1}, reason);
  particles.for_each_field([&](const Field& field) {
    if (field.components == 0) return;
    const auto columns = static_cast<std::size_t>(field.components);
    expect_size(file, group + field.name, {rows, columns}, reason);
  });
  check_counts(file, group + "rank_counts", ranks, rows);
}

void check_tables(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  std::string fault = fault_of_numbers(scene, state, checkpoint);
  if (!fault.empty()) throw WrongTable{fault, 0};
  const auto ranks = static_cast<long long>(number_of(checkpoint.numbers, "ranks"));
  check_owners(*checkpoint.open, state, ranks);
  if (has_tile_steps(state)) check_tile_steps(*checkpoint.open, state.grid.box);
  check_sums(*checkpoint.open, state);
  for (const Particles& particles : state.particles)
    check_sizes(particles, *checkpoint.open, ranks);
}

}  // namespace

void name_checkpoint(const Checkpoint& checkpoint, const std::function<void()>& check) {
  try {
    check();
  } catch (const WrongTable& found) {
    throw FileError(
        "cannot resume from '" + checkpoint.file.string() + "' (" + found.words +
        "); remove this file to continue from the previous checkpoint, or start again with barreno "
        "run."
    );
  }
}

void check_checkpoint(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  const Region region("check_checkpoint");
  const Comm& comm = *state.grid.comm;
  name_checkpoint(checkpoint, [&] {
    check_together(comm, 0, [&] {
      if (is_root(comm)) check_tables(scene, state, checkpoint);
    });
  });
}

}  // namespace barreno
