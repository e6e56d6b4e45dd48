// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/check_values.hpp"

#include "base/error.hpp"
#include "base/exchange.hpp"
#include "base/region.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/first_fault.hpp"
#include "checkpoint/own_rows.hpp"
#include "output/text_file.hpp"
#include "state/balance.hpp"
#include "state/id_ranges.hpp"
#include "state/load_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace barreno {
namespace {

std::string shape_text(const Hdf5Size& size) {
  return std::to_string(size.rows) + " x " + std::to_string(size.columns);
}

void expect_size(const Hdf5File& file, const std::string& name, const Hdf5Size& wanted) {
  const Hdf5Size found = file.size_of(name);
  if (found.rows != wanted.rows || found.columns != wanted.columns)
    throw WrongTable{name + " is " + shape_text(found) + " instead of " + shape_text(wanted), 0};
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

/// The same for this rank's part of the rows.
template <class T, class Visitor>
void for_each_part_value(
    const Comm& comm,
    const Hdf5File& file,
    const std::string& name,
    std::size_t rows,
    Visitor&& visit
) {
  expect_size(file, name, {rows, 1});
  for_part_of_rows<T>(comm, file, name, [&](std::size_t row, const T* value) {
    visit(row, *value);
  });
}

template <class Number>
[[noreturn]] void refuse_value(const std::string& name, std::size_t row, Number value) {
  throw WrongTable{
      name + " is " + to_text(static_cast<double>(value)) + " in row " + std::to_string(row), row};
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
    if (!fine) throw WrongTable{name + " holds no sum in row " + std::to_string(row), row};
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
  Ids(const Scene& scene,
      const std::vector<IdRange>& ids,
      const State& state,
      const Checkpoint& checkpoint,
      int material) {
    const auto next = static_cast<std::size_t>(number_of(checkpoint.numbers, "next_slug"));
    for (IdRange range : ids) {
      if (range.material != material) continue;
      const bool jet = scene.jet.present && next < state.jet.slug_ids.size() &&
                       range.first == state.jet.slug_ids.front();
      if (jet) range.count = state.jet.slug_ids[next] - range.first;
      begins_.push_back(count_);
      ranges_.push_back(range);
      count_ += range.count;
    }
  }
  long long count() const { return count_; }
  /// The place of an id among them; -1 if it is none of them.
  long long place_of(ParticleId id) const {
    for (std::size_t r = 0; r < ranges_.size(); ++r) {
      if (id < ranges_[r].first) continue;
      const ParticleId place = id - ranges_[r].first;
      if (place < ranges_[r].count) return begins_[r] + place;
    }
    return -1;
  }

private:
  std::vector<IdRange> ranges_;
  std::vector<long long> begins_;
  long long count_ = 0;
};

/// Rows of ids on their way to the rank that looks whether an id comes twice: places are dealt out
/// in equal spans.
struct SentIds {
  std::vector<std::vector<double>> by_rank;  ///< row, place, row, place ...
  long long places_each;

  SentIds(const Comm& comm, long long places)
      : by_rank(static_cast<std::size_t>(comm.getSize())),
        places_each(std::max(1LL, (places + comm.getSize() - 1) / comm.getSize())) {}
  void add(std::size_t row, long long place) {
    std::vector<double>& rows = by_rank[static_cast<std::size_t>(place / places_each)];
    rows.push_back(static_cast<double>(row));
    rows.push_back(static_cast<double>(place));
  }
};

/// Every id is one of those that may be, and none comes twice. Collective.
void check_ids(
    const Comm& comm,
    const Hdf5File& file,
    const std::string& name,
    std::size_t rows,
    const Ids& ids
) {
  const std::size_t begin = part_of_rows(comm, rows).begin;
  SentIds sent(comm, ids.count());
  check_together(comm, begin, [&] {
    for_each_part_value<long long>(comm, file, name, rows, [&](std::size_t row, long long id) {
      const long long place = ids.place_of(id);
      if (place < 0) refuse_value(name, row, id);
      sent.add(row, place);
    });
  });
  const std::vector<double> received = exchange_rows(comm, sent.by_rank);  // by ascending row
  check_together(comm, begin, [&] {
    std::vector<bool> seen(static_cast<std::size_t>(sent.places_each), false);
    for (std::size_t i = 0; i < received.size(); i += 2) {
      const auto row = static_cast<std::size_t>(received[i]);
      const auto place = static_cast<long long>(received[i + 1]);
      const auto mine = static_cast<std::size_t>(place % sent.places_each);
      if (seen[mine]) refuse_value(name, row, file.read_rows<long long>(name, row, 1)[0]);
      seen[mine] = true;
    }
  });
}

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
        name + " adds up to " + std::to_string(sum) + " instead of " + std::to_string(all), 0};
}

void check_bodies(
    const Comm& comm,
    const Hdf5File& file,
    const Scene& scene,
    int material,
    const std::string& name,
    std::size_t rows
) {
  const auto bodies = static_cast<long long>(scene.bodies.size());
  for_each_part_value<long long>(comm, file, name, rows, [&](std::size_t row, long long value) {
    const long long body = value & ~static_cast<long long>(debris_bit);
    const bool of_body = body >= 0 && body < bodies &&
                         scene.bodies[static_cast<std::size_t>(body)].material == material;
    const bool of_jet = scene.jet.present && body == bodies && scene.jet.material == material;
    if (!of_body && !of_jet) refuse_value(name, row, value);
  });
}

/// Causes of removal in this rank's part of the rows; -1 for particles that stay.
struct Causes {
  std::size_t begin = 0;
  std::vector<signed char> of_row;
  bool stays(std::size_t row) const { return of_row[row - begin] < 0; }
};

Causes read_causes(
    const Comm& comm, const Hdf5File& file, const std::string& name, std::size_t rows
) {
  Causes causes{part_of_rows(comm, rows).begin, {}};
  for_each_part_value<long long>(comm, file, name, rows, [&](std::size_t row, long long cause) {
    if (cause < -1 || cause >= removal_causes) refuse_value(name, row, cause);
    causes.of_row.push_back(static_cast<signed char>(cause));
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
    const Scene& scene,
    const Comm& comm,
    const Hdf5File& file,
    const std::string& group,
    const Field& field,
    const Hdf5Size& size,
    const Causes& causes
) {
  const std::string name = group + field.name;
  expect_size(file, name, size);
  for_part_of_rows<double>(comm, file, name, [&](std::size_t row, const double* values) {
    for (std::size_t c = 0; causes.stays(row) && c < size.columns; ++c)
      if (!is_possible(scene, field.name, values[c])) refuse_value(name, row, values[c]);
  });
}

void check_inside(
    const State& state, const Hdf5File& file, const std::string& name, const Causes& causes
) {
  const auto columns = static_cast<std::size_t>(dimensions(state.grid.mode));
  for_part_of_rows<double>(
      *state.grid.comm,
      file,
      name,
      [&](std::size_t row, const double* values) {
        Vector x{};
        std::copy_n(values, columns, x.data());
        if (causes.stays(row) && !state.grid.holds(x))
          throw WrongTable{name + " is outside the grid in row " + std::to_string(row), row};
      }
  );
}

/// Fields of a material's particles. Collective.
void check_fields(
    const Scene& scene,
    const State& state,
    const Particles& particles,
    const Hdf5File& file,
    std::size_t rows
) {
  const Comm& comm = *state.grid.comm;
  const std::string group = particle_group(particles);
  const std::size_t begin = part_of_rows(comm, rows).begin;
  Causes causes;
  check_together(comm, begin, [&] { causes = read_causes(comm, file, group + "removal", rows); });
  particles.for_each_field([&](const Field& field) {
    if (field.components == 0) return;
    const Hdf5Size size{rows, static_cast<std::size_t>(field.components)};
    check_together(comm, begin, [&] {
      check_field(scene, comm, file, group, field, size, causes);
    });
  });
  check_together(comm, begin, [&] { check_inside(state, file, group + "position", causes); });
}

/// Rows of particles: each rank looks at its equal part. Collective.
void check_particles(
    const Scene& scene,
    const std::vector<IdRange>& ids,
    const State& state,
    const Particles& particles,
    const Checkpoint& checkpoint
) {
  const Comm& comm = *state.grid.comm;
  const Hdf5File& file = *checkpoint.open;
  const std::string group = particle_group(particles);
  std::size_t rows = 0;
  check_together(comm, 0, [&] { rows = file.size_of(group + "id").rows; });
  const Ids allowed(scene, ids, state, checkpoint, particles.material);
  check_ids(comm, file, group + "id", rows, allowed);
  check_together(comm, part_of_rows(comm, rows).begin, [&] {
    if (is_root(comm)) {
      const auto ranks = static_cast<long long>(number_of(checkpoint.numbers, "ranks"));
      check_counts(file, group + "rank_counts", ranks, rows);
    }
  });
  check_together(comm, part_of_rows(comm, rows).begin, [&] {
    check_bodies(comm, file, scene, particles.material, group + "body", rows);
  });
  check_fields(scene, state, particles, file, rows);
}

/// What rank 0 alone looks at: it is small, or not in the file.
void check_small_tables(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  std::string fault = fault_of_numbers(scene, state, checkpoint);
  if (!fault.empty()) throw WrongTable{fault, 0};
  const auto ranks = static_cast<long long>(number_of(checkpoint.numbers, "ranks"));
  check_owners(*checkpoint.open, state, ranks);
  check_sums(*checkpoint.open, state);
}

}  // namespace

void check_checkpoint(
    const Scene& scene,
    const std::vector<IdRange>& ids,
    const State& state,
    const Checkpoint& checkpoint
) {
  const Region region("check_checkpoint");
  const Comm& comm = *state.grid.comm;
  try {
    check_together(comm, 0, [&] {
      if (is_root(comm)) check_small_tables(scene, state, checkpoint);
    });
    for (const Particles& particles : state.particles)
      check_particles(scene, ids, state, particles, checkpoint);
  } catch (const WrongTable& found) {
    throw FileError(
        "cannot resume from '" + checkpoint.file.string() + "' (" + found.words +
        "); remove this file to continue from the previous checkpoint, or start again with barreno "
        "run."
    );
  }
}

}  // namespace barreno
