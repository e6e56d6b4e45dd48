// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/read_particles.hpp"

#include "base/exchange.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/first_fault.hpp"
#include "checkpoint/own_rows.hpp"
#include "state/load_table.hpp"
#include "step/order/remove_lost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace barreno {
namespace {

/// Ids that particles of a material may have: its bodies', and those of slugs that were launched.
class AllowedIds {
public:
  AllowedIds(const KnownRun& run, int material) {
    const auto next = static_cast<std::size_t>(number_of(run.checkpoint.numbers, "next_slug"));
    for (IdRange range : run.ids) {
      if (range.material != material) continue;
      const bool jet = run.scene.jet.present && next < run.jet.slug_ids.size() &&
                       range.first == run.jet.slug_ids.front();
      if (jet) range.count = run.jet.slug_ids[next] - range.first;
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

/// (row, place) of the ids that this rank looks at, by ascending row. Collective.
std::vector<std::pair<std::size_t, long long>> received_ids(const Comm& comm, const SentIds& sent) {
  const std::vector<double> values = exchange_rows(comm, sent.by_rank);
  std::vector<std::pair<std::size_t, long long>> ids;
  for (std::size_t i = 0; i < values.size(); i += 2)
    ids.emplace_back(static_cast<std::size_t>(values[i]), static_cast<long long>(values[i + 1]));
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// One material's rows that are being read.
class RowReader {
public:
  RowReader(const KnownRun& run, const std::vector<std::size_t>& rows, Particles& particles)
      : run_(run),
        comm_(*run.grid.comm),
        file_(*run.checkpoint.open),
        rows_(rows),
        group_(particle_group(particles)),
        particles_(particles) {}

  /// Every id is one of those that may be, and none comes twice. Collective.
  void read_ids() {
    const AllowedIds allowed(run_, particles_.material);
    const std::string name = group_ + "id";
    SentIds sent(comm_, allowed.count());
    together([&] {
      for_own_rows<long long>(rows_, file_, name, [&](int p, const long long* id) {
        const long long place = allowed.place_of(*id);
        if (place < 0) refuse(name, p, static_cast<double>(*id));
        particles_.id(p) = static_cast<ParticleId>(*id);
        sent.add(row(p), place);
      });
    });
    const auto received = received_ids(comm_, sent);
    together([&] {
      std::vector<bool> seen(static_cast<std::size_t>(sent.places_each), false);
      for (const auto& [row, place] : received) {
        const auto mine = static_cast<std::size_t>(place % sent.places_each);
        if (seen[mine])
          refuse_value(name, row, static_cast<double>(file_.read_rows<long long>(name, row, 1)[0]));
        seen[mine] = true;
      }
    });
  }
  /// Collective, as all that follow.
  void read_bodies() {
    const std::string name = group_ + "body";
    together([&] {
      for_own_rows<long long>(rows_, file_, name, [&](int p, const long long* body) {
        if (!is_body(*body)) refuse(name, p, static_cast<double>(*body));
        particles_.body(p) = static_cast<int>(*body);
      });
    });
  }
  void read_causes() {
    const std::string name = group_ + "removal";
    stays_.assign(rows_.size(), true);
    together([&] {
      for_own_rows<long long>(rows_, file_, name, [&](int p, const long long* cause) {
        if (*cause < -1 || *cause >= removal_causes) refuse(name, p, static_cast<double>(*cause));
        particles_.fault(p) = fault_of_cause(static_cast<int>(*cause));
        stays_[static_cast<std::size_t>(p)] = *cause < 0;
      });
    });
  }
  void read_field(Field& field) {
    const std::string name = group_ + field.name;
    together([&] {
      for_own_rows<double>(rows_, file_, name, [&](int p, const double* values) {
        const bool stays = stays_[static_cast<std::size_t>(p)];
        for (int c = 0; c < field.components; ++c) {
          if (stays && !is_possible(field.name, values[c])) refuse(name, p, values[c]);
          field(p, c) = values[c];
        }
      });
    });
  }
  void check_inside() const {
    const std::string name = group_ + "position";
    together([&] {
      for (int p = 0; p < particles_.count; ++p)
        if (stays_[static_cast<std::size_t>(p)] &&
            !run_.grid.holds(vector_of(particles_.position, p)))
          throw WrongTable{name + " is outside the grid in row " + std::to_string(row(p)), row(p)};
    });
  }

private:
  std::size_t row(int p) const { return rows_[static_cast<std::size_t>(p)]; }
  void together(const std::function<void()>& check) const {
    check_together(comm_, rows_.empty() ? 0 : rows_.front(), check);
  }
  [[noreturn]] void refuse(const std::string& name, int p, double value) const {
    refuse_value(name, row(p), value);
  }
  bool is_body(long long value) const {
    const Scene& scene = run_.scene;
    const long long body = value & ~static_cast<long long>(debris_bit);
    const auto bodies = static_cast<long long>(scene.bodies.size());
    const bool of_body =
        body >= 0 && body < bodies &&
        scene.bodies[static_cast<std::size_t>(body)].material == particles_.material;
    return of_body ||
           (scene.jet.present && body == bodies && scene.jet.material == particles_.material);
  }
  /// Whether a value may stand in a field of a particle that stays.
  bool is_possible(const std::string& field, double value) const {
    if (!std::isfinite(value)) return false;
    // Nor a denormal one, by which nothing can be divided.
    if (field == "mass" || field == "volume") return value >= std::numeric_limits<double>::min();
    // A particle of one per cell, and a sliver that has joined it: nodes farther off are not kept.
    if (field == "half_size") return value > 0.0 && value <= run_.scene.grid.cell_size;
    if (field == "longitudinal_modulus") return value >= 0.0;
    if (field == "clipped") return value == 0.0 || value == 1.0;
    if (field == "loaded_faces")
      return value >= 0.0 && value == std::floor(value) &&
             value < std::ldexp(1.0, max_loaded_faces(run_.scene));
    return true;
  }

  const KnownRun& run_;
  const Comm& comm_;
  const Hdf5File& file_;
  const std::vector<std::size_t>& rows_;
  std::string group_;
  Particles& particles_;
  std::vector<bool> stays_;  ///< by row of the set
};

}  // namespace

void read_particles(
    const KnownRun& run, const std::vector<std::size_t>& rows, Particles& particles
) {
  reserve(particles, static_cast<int>(rows.size()));
  particles.count = static_cast<int>(rows.size());
  particles.sorted = false;
  for (int p = 0; p < particles.count; ++p) mark_unplaced(particles, p);
  RowReader reader(run, rows, particles);
  reader.read_ids();
  reader.read_bodies();
  reader.read_causes();
  particles.for_each_field([&](Field& field) {
    if (field.components > 0) reader.read_field(field);
  });
  reader.check_inside();
}

}  // namespace barreno
