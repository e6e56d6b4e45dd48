// SPDX-License-Identifier: BSD-3-Clause
#include "state/bodies/box_in_parcels.hpp"

#include "base/work_counts.hpp"
#include "state/bodies/box_divisions.hpp"

#include <array>
#include <variant>

namespace barreno {
namespace {

/// Places [begin, end) along an axis that lie in one layer of tiles.
struct Run {
  int layer = 0;
  long long begin = 0, end = 0;
};
using Runs = std::array<std::vector<Run>, 3>;

/// Layer of the tiles that a coordinate lies in, by the same numbers as for a particle there.
int layer_of(const Grid& grid, const CellLattice& cells, std::size_t axis, double place) {
  Vector x{grid.lower[0], grid.lower[1], grid.lower[2]};
  x[axis] = place;
  int tile = cells.cell_at([&](int d) { return x[static_cast<std::size_t>(d)]; }).box_tile;
  for (std::size_t d = 0; d < axis; ++d) tile /= grid.tiles[d];
  return tile;
}

Runs runs_of(const Grid& grid, const CellLattice& cells, const Divisions& divisions) {
  Runs runs;
  runs[2] = {{0, 0, 1}};
  for (std::size_t d = 0; d < static_cast<std::size_t>(cells.dimensions); ++d) {
    const Division& division = divisions.along[d];
    runs[d].clear();
    for (long long i = 0; i < division.count; ++i) {
      const int layer = layer_of(grid, cells, d, division.centre(i));
      if (runs[d].empty() || runs[d].back().layer != layer) runs[d].push_back({layer, i, i});
      runs[d].back().end = i + 1;
    }
    work_counts().undivided_points += division.count;
  }
  return runs;
}

int tile_of(const Grid& grid, const Run& x, const Run& y, const Run& z) {
  return (z.layer * grid.tiles[1] + y.layer) * grid.tiles[0] + x.layer;
}

/// Rows of places along x in one layer of tiles along y, of a layer along z, and what of them is in
/// this rank's tiles.
struct OwnRows {
  long long begin = 0, end = 0;
  std::vector<Run> along_x;
};

std::vector<OwnRows> own_rows(const Grid& grid, const Runs& runs, const Run& z) {
  const int me = grid.comm->getRank();
  work_counts().undivided_points += static_cast<long long>(runs[1].size() * runs[0].size());
  std::vector<OwnRows> found;
  for (const Run& y : runs[1]) {
    OwnRows rows{y.begin, y.end, {}};
    for (const Run& x : runs[0])
      if (owner_of(grid, tile_of(grid, x, y, z)) == me) rows.along_x.push_back(x);
    if (!rows.along_x.empty()) found.push_back(std::move(rows));
  }
  return found;
}

/// visit(index) for the places of this rank's tiles, x fastest.
template <class Visitor>
void for_each_own_place(const Grid& grid, const Runs& runs, Visitor&& visit) {
  PlaceIndex i{};
  for (const Run& z : runs[2]) {
    const std::vector<OwnRows> own = own_rows(grid, runs, z);
    if (own.empty()) continue;
    for (i[2] = z.begin; i[2] < z.end; ++i[2])
      for (const OwnRows& rows : own)
        for (i[1] = rows.begin; i[1] < rows.end; ++i[1])
          for (const Run& x : rows.along_x)
            for (i[0] = x.begin; i[0] < x.end; ++i[0]) visit(i);
  }
}

}  // namespace

void count_box_in_parcels(
    const Scene& scene, const BodySpec& body, const Grid& grid, std::vector<ParcelCost>& parcels
) {
  const CellLattice cells(grid);
  const auto count = [&](const GridSpec& /*own*/, const Divisions& divisions, unsigned /*ends*/) {
    const Runs runs = runs_of(grid, cells, divisions);
    for (const Run& z : runs[2])
      for (const Run& y : runs[1])
        for (const Run& x : runs[0])
          parcels[static_cast<std::size_t>(grid.parcels.holding(tile_of(grid, x, y, z)))]
              .particles +=
              static_cast<double>((z.end - z.begin) * (y.end - y.begin) * (x.end - x.begin));
  };
  for_each_box_part(scene.grid, body, std::get<Box>(body.shape), box_cuts(scene), count);
}

void for_each_own_box_particle(
    const Scene& scene,
    const BodySpec& body,
    const Grid& grid,
    const std::function<void(const NewParticle&)>& visit
) {
  const CellLattice cells(grid);
  ParticleId first = 0;
  const auto fill = [&](const GridSpec& own, const Divisions& divisions, unsigned ends) {
    const auto& along = divisions.along;
    for_each_own_place(grid, runs_of(grid, cells, divisions), [&](const PlaceIndex& i) {
      NewParticle particle = particle_at(own, divisions, i);
      particle.id = first + (i[2] * along[1].count + i[1]) * along[0].count + i[0];
      particle.loaded_sides &= ends;
      ++work_counts().candidate_points;
      visit(particle);
    });
    first += count_places(divisions);
  };
  for_each_box_part(scene.grid, body, std::get<Box>(body.shape), box_cuts(scene), fill);
}

}  // namespace barreno
