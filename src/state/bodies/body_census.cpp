// SPDX-License-Identifier: BSD-3-Clause
#include "state/bodies/body_census.hpp"

#include "base/region.hpp"
#include "base/work_counts.hpp"
#include "grid/tiles.hpp"
#include "state/bodies/box_in_parcels.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <variant>

namespace barreno {
namespace {

bool is_box(const BodySpec& body) {
  return std::holds_alternative<Box>(body.shape);
}

/// Particles in this rank's share of a body's lattice, each added to its parcel.
long long count_share(
    const Scene& scene, const BodySpec& body, const Grid& grid, std::vector<double>& parcels
) {
  const CellSpan share =
      share_of_cells(body_lattice(scene.grid, body), grid.comm->getRank(), grid.comm->getSize());
  const CellLattice cells(grid);
  long long count = 0;
  for_each_lattice_particle(scene.grid, body, share, 0, [&](const NewParticle& p) {
    const Cell cell = cells.cell_at([&](int d) { return p.x[static_cast<std::size_t>(d)]; });
    parcels[static_cast<std::size_t>(grid.parcels.holding(cell.box_tile))] += 1.0;
    ++count;
  });
  return count;
}

/// Sums over the lower ranks.
std::vector<long long> sums_before(const Comm& comm, const std::vector<long long>& mine) {
  std::vector<long long> sums(mine.size());
  const auto size = static_cast<int>(mine.size());
  if (size > 0)
    Teuchos::scan<int, long long>(comm, Teuchos::REDUCE_SUM, size, mine.data(), sums.data());
  for (std::size_t i = 0; i < mine.size(); ++i) sums[i] -= mine[i];
  return sums;
}

/// Slugs are dealt to the ranks one by one.
void count_slugs(const Scene& scene, const Comm& comm, std::vector<long long>& counts) {
  const std::size_t bodies = scene.bodies.size();
  const auto ranks = static_cast<std::size_t>(comm.getSize());
  for (auto s = static_cast<std::size_t>(comm.getRank()); s < scene.jet.slugs.size(); s += ranks)
    counts[bodies + s] = count_slug_particles(scene, scene.jet.slugs[s]);
}

}  // namespace

BodyCensus take_census(const Scene& scene, const Teuchos::RCP<const Comm>& comm) {
  const Region region("take_census");
  constexpr int any_reach = 1;  // of nodes, which are not asked for
  const Grid grid = make_grid(scene, any_reach, comm);
  work_counts().undivided_points += static_cast<long long>(grid.owner.size());
  BodyCensus census;
  census.counts.resize(scene.bodies.size() + scene.jet.slugs.size(), 0);
  std::vector<double> in_shares(grid.owner.size(), 0.0);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!is_box(scene.bodies[b]))
      census.counts[b] = count_share(scene, scene.bodies[b], grid, in_shares);
  count_slugs(scene, *comm, census.counts);
  census.before = sums_before(*comm, census.counts);
  sum_over_ranks(*comm, census.counts);
  sum_over_ranks(*comm, in_shares);  // whole numbers: in any order the same
  census.parcels.resize(in_shares.size());
  for (std::size_t i = 0; i < in_shares.size(); ++i) census.parcels[i].particles = in_shares[i];
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!is_box(scene.bodies[b])) continue;
    census.counts[b] = count_body_particles(scene.grid, scene.bodies[b], box_cuts(scene));
    count_box_in_parcels(scene, scene.bodies[b], grid, census.parcels);
  }
  census.first = first_ids(scene, census.counts);
  return census;
}

}  // namespace barreno
