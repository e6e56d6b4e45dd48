// SPDX-License-Identifier: BSD-3-Clause
// How particles come to the ranks that write them: one exchange for each material.
#include "base/exchange.hpp"
#include "output/exodus_writer.hpp"
#include "output/particle_fields.hpp"

#include <cmath>
#include <cstring>
#include <numeric>

namespace barreno {
namespace {

/// Rows of the particles in the order of the ranks that they go to.
std::vector<int> sort_by_rank(const std::vector<int>& ranks, std::vector<int>& counts) {
  std::vector<int> next(counts.size(), 0), order(ranks.size());
  for (const int rank : ranks) ++counts[static_cast<std::size_t>(rank)];
  std::partial_sum(counts.begin(), counts.end() - 1, next.begin() + 1);
  for (std::size_t p = 0; p < ranks.size(); ++p)
    order[static_cast<std::size_t>(next[static_cast<std::size_t>(ranks[p])]++)] =
        static_cast<int>(p);
  return order;
}

double id_as_double(ParticleId id) {
  double bits = 0.0;
  static_assert(sizeof bits == sizeof id);
  std::memcpy(&bits, &id, sizeof id);
  return bits;
}

}  // namespace

/// The id, node positions, the element variables, then the radius of a point.
std::vector<double> ExodusWriter::pack_rows(
    const Scene& scene,
    const State& state,
    const std::vector<double>& tile_steps,
    std::size_t set,
    std::vector<int>& counts
) const {
  const HostParticles particles(state.particles[set]);
  const MaterialSpec& material = scene.materials[set];
  const CellsAndSteps own(
      optional_fields(scene, material), state.grid, tile_steps, state.particles[set]
  );
  const std::size_t width = row_width(scene, set);
  const auto ranks = static_cast<int>(counts.size());
  std::vector<int> holders(static_cast<std::size_t>(particles.count));
  for (int p = 0; p < particles.count; ++p)
    holders[static_cast<std::size_t>(p)] =
        writing_rank(shares_, position_of(shares_, set, particles.id(p)).file, ranks);
  std::vector<double> values;
  values.reserve(holders.size() * width);
  for (const int p : sort_by_rank(holders, counts)) {
    values.push_back(id_as_double(particles.id(p)));
    if (nodes_ == 1) {
      for (int d = 0; d < dimensions_; ++d) values.push_back(particles.position(p, d));
    } else {
      particles.append_corners(p, values);
    }
    append_particle_fields(particles, p, material.density(), own, values);
    double size = 1.0;
    for (int d = 0; d < dimensions_; ++d) size *= particles.half_size(p, d);
    values.push_back(std::pow(size, 1.0 / dimensions_));
  }
  for (int& count : counts) count *= static_cast<int>(width);
  return values;
}

ExodusWriter::Rows ExodusWriter::bring_rows(
    const Scene& scene, const State& state, const std::vector<double>& tile_steps, std::size_t set
) const {
  const Comm& comm = *state.grid.comm;
  std::vector<int> counts(static_cast<std::size_t>(comm.getSize()), 0);
  const std::vector<double> mine = pack_rows(scene, state, tile_steps, set, counts);
  Rows rows;
  rows.values = exchange(comm, mine, counts);
  rows.of_file.resize(open_files_.size());
  const std::size_t width = row_width(scene, set);
  for (std::size_t begin = 0; begin < rows.values.size(); begin += width) {
    ParticleId id = 0;
    std::memcpy(&id, &rows.values[begin], sizeof id);
    const FilePosition place = position_of(shares_, set, id);
    const auto h = static_cast<std::size_t>(place.file - open_files_.front().number);
    rows.of_file[h].push_back({open_files_[h].begin[set] + place.element, begin + 1});
  }
  return rows;
}

}  // namespace barreno
