// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/check_values.hpp"

#include "base/error.hpp"
#include "base/region.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "output/text_file.hpp"
#include "state/balance.hpp"
#include "state/id_ranges.hpp"
#include "state/load_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace barreno {
namespace {

/// Leaves with what is wrong; the file is the root's.
struct WrongTable {
  std::string words;
};

std::string shape_text(const Hdf5Size& size) {
  return std::to_string(size.rows) + " x " + std::to_string(size.columns);
}

void expect_size(const Hdf5File& file, const std::string& name, const Hdf5Size& wanted) {
  const Hdf5Size found = file.size_of(name);
  if (found.rows != wanted.rows || found.columns != wanted.columns)
    throw WrongTable{name + " is " + shape_text(found) + " instead of " + shape_text(wanted)};
}

/// visit(row, values) chunk by chunk.
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

template <class Number>
[[noreturn]] void refuse_value(const std::string& name, std::size_t row, Number value) {
  throw WrongTable{
      name + " is " + to_text(static_cast<double>(value)) + " in row " + std::to_string(row)};
}

void check_owners(const Hdf5File& file, const State& state, long long ranks) {
  const std::string name = "grid/owner";
  for_each_value<long long>(
      file,
      name,
      state.grid.owner.size(),
      [&](std::size_t row, long long owner) {
        if (owner < 0 || owner >= ranks) refuse_value(name, row, owner);
      }
  );
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
    if (!fine) throw WrongTable{name + " holds no sum in row " + std::to_string(row)};
  });
}

void check_sums(const Hdf5File& file, const State& state) {
  check_reproducible_sums(file, "ledger/terms", terms_of(state.ledger).size());
  check_reproducible_sums(file, "ledger/reactions", 3 * state.reactions.size());
  const auto check_counts = [&](const std::string& name, std::size_t rows) {
    for_each_value<double>(file, name, rows, [&](std::size_t row, double steps) {
      if (!(steps >= 0.0 && std::isfinite(steps))) refuse_value(name, row, steps);
    });
  };
  check_counts("ledger/particle_steps", 2);
  check_counts("ledger/step_shares", values_of(state.step_shares).size());
}

/// Ids that particles of a material may have: its bodies', and those of slugs that were launched.
class Ids {
public:
  Ids(const Scene& scene, const State& state, const Checkpoint& checkpoint, int material) {
    const auto next = static_cast<std::size_t>(number_of(checkpoint.numbers, "next_slug"));
    for (IdRange range : particle_id_ranges(scene)) {
      if (range.material != material) continue;
      const bool jet = scene.jet.present && next < state.jet.slug_ids.size() &&
                       range.first == state.jet.slug_ids.front();
      if (jet) range.count = state.jet.slug_ids[next] - range.first;
      begins_.push_back(seen_.size());
      ranges_.push_back(range);
      seen_.resize(seen_.size() + static_cast<std::size_t>(range.count), false);
    }
  }
  /// @return whether it is one of them, and new
  bool take(ParticleId id) {
    for (std::size_t r = 0; r < ranges_.size(); ++r) {
      const ParticleId place = id - ranges_[r].first;
      if (id < ranges_[r].first || place >= ranges_[r].count) continue;
      const std::size_t at = begins_[r] + static_cast<std::size_t>(place);
      if (seen_[at]) return false;
      seen_[at] = true;
      return true;
    }
    return false;
  }

private:
  std::vector<IdRange> ranges_;
  std::vector<std::size_t> begins_;
  std::vector<bool> seen_;
};

void check_counts(const Hdf5File& file, const std::string& name, long long ranks, std::size_t all) {
  const auto most = static_cast<long long>(all);
  long long sum = 0;
  for_each_value<long long>(
      file,
      name,
      static_cast<std::size_t>(ranks),
      [&](std::size_t row, long long count) {
        if (count < 0 || count > most - sum) refuse_value(name, row, count);
        sum += count;
      }
  );
  if (sum != most)
    throw WrongTable{
        name + " adds up to " + std::to_string(sum) + " instead of " + std::to_string(all)};
}

void check_bodies(
    const Hdf5File& file,
    const Scene& scene,
    int material,
    const std::string& name,
    std::size_t rows
) {
  const auto bodies = static_cast<long long>(scene.bodies.size());
  for_each_value<long long>(file, name, rows, [&](std::size_t row, long long value) {
    const long long body = value & ~static_cast<long long>(debris_bit);
    const bool of_body = body >= 0 && body < bodies &&
                         scene.bodies[static_cast<std::size_t>(body)].material == material;
    const bool of_jet = scene.jet.present && body == bodies && scene.jet.material == material;
    if (!of_body && !of_jet) refuse_value(name, row, value);
  });
}

/// Causes of removal by row; -1 for those that stay.
std::vector<signed char> read_causes(
    const Hdf5File& file, const std::string& name, std::size_t rows
) {
  std::vector<signed char> causes(rows);
  for_each_value<long long>(file, name, rows, [&](std::size_t row, long long cause) {
    if (cause < -1 || cause >= removal_causes) refuse_value(name, row, cause);
    causes[row] = static_cast<signed char>(cause);
  });
  return causes;
}

/// Whether a value may stand in a field of a particle that stays.
bool is_possible(const Scene& scene, const std::string& field, double value) {
  if (!std::isfinite(value)) return false;
  if (field == "mass" || field == "volume") return value > 0.0;
  // A particle of one per cell, and a sliver that has joined it: nodes farther off are not kept.
  if (field == "half_size") return value > 0.0 && value <= scene.grid.cell_size;
  if (field == "longitudinal_modulus") return value >= 0.0;
  if (field == "clipped") return value == 0.0 || value == 1.0;
  if (field == "loaded_faces")
    return value >= 0.0 && value == std::floor(value) &&
           value < std::ldexp(1.0, max_loaded_faces(scene));
  return true;
}

void check_field(
    const Hdf5File& file,
    const Scene& scene,
    const std::string& group,
    const Field& field,
    const std::vector<signed char>& causes
) {
  const std::string name = group + field.name;
  const auto columns = static_cast<std::size_t>(field.components);
  expect_size(file, name, {causes.size(), columns});
  for_each_row<double>(file, name, [&](std::size_t row, const double* values) {
    for (std::size_t c = 0; causes[row] < 0 && c < columns; ++c)
      if (!is_possible(scene, field.name, values[c])) refuse_value(name, row, values[c]);
  });
}

void check_inside(
    const Hdf5File& file,
    const State& state,
    const std::string& name,
    const std::vector<signed char>& causes
) {
  const auto columns = static_cast<std::size_t>(dimensions(state.grid.mode));
  for_each_row<double>(file, name, [&](std::size_t row, const double* values) {
    Vector x{};
    std::copy_n(values, columns, x.data());
    if (causes[row] < 0 && !state.grid.holds(x))
      throw WrongTable{name + " is outside the grid in row " + std::to_string(row)};
  });
}

void check_particles(
    const Scene& scene,
    const State& state,
    const Particles& particles,
    const Checkpoint& checkpoint,
    long long ranks
) {
  const Hdf5File& file = *checkpoint.open;
  const std::string group = particle_group(particles);
  const std::size_t rows = file.size_of(group + "id").rows;
  Ids ids(scene, state, checkpoint, particles.material);
  for_each_value<long long>(file, group + "id", rows, [&](std::size_t row, long long id) {
    if (!ids.take(id)) refuse_value(group + "id", row, id);
  });
  check_counts(file, group + "rank_counts", ranks, rows);
  check_bodies(file, scene, particles.material, group + "body", rows);
  const std::vector<signed char> causes = read_causes(file, group + "removal", rows);
  particles.for_each_field([&](const Field& field) {
    if (field.components > 0) check_field(file, scene, group, field, causes);
  });
  check_inside(file, state, group + "position", causes);
}

std::string find_fault(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  std::string fault = fault_of_numbers(scene, state, checkpoint);
  if (!fault.empty()) return fault;
  const Hdf5File& file = *checkpoint.open;
  const auto ranks = static_cast<long long>(number_of(checkpoint.numbers, "ranks"));
  try {
    check_owners(file, state, ranks);
    check_sums(file, state);
    for (const Particles& particles : state.particles)
      check_particles(scene, state, particles, checkpoint, ranks);
  } catch (const WrongTable& found) {
    fault = found.words;
  }
  return fault;
}

}  // namespace

void check_checkpoint(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  const Region region("check_checkpoint");
  RootWork work(*state.grid.comm);
  work.run([&] {
    const std::string fault = find_fault(scene, state, checkpoint);
    if (fault.empty()) return;
    throw FileError(
        "cannot resume from '" + checkpoint.file.string() + "' (" + fault +
        "); remove this file to continue from the previous checkpoint, or start again with barreno "
        "run."
    );
  });
  work.agree();
}

}  // namespace barreno
