// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/find_early_arrivals.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/rows.hpp"
#include "state/row_frames.hpp"

namespace barreno {
namespace {

struct IsEarly {
  CellLattice lattice;
  RowFrames frames;
  FieldView position;
  ArrayView<Fault> fault;
  ArrayView<int> directory;
  ArrayView<unsigned char> level_of_tile;
  Subcycling subcycling;
  double lower[3], upper[3];

  /// Those that have left the grid or failed are removed before they come anywhere.
  KOKKOS_INLINE_FUNCTION bool is_lost(int p) const {
    bool inside = fault(p) == Fault::none;
    for (int d = 0; d < lattice.dimensions; ++d)
      inside = inside && position(p, d) >= lower[d] && position(p, d) < upper[d];
    return !inside;
  }
  KOKKOS_INLINE_FUNCTION bool operator()(int p) const {
    const int from = frames.tile(p);
    if (subcycling.ends(from) == 0 || is_lost(p)) return false;
    const Cell cell = lattice.cell_at(position, p);
    // Of another rank's finer tiles it is not known here which are active.
    if (level_of_tile.extent(0) > 0 &&
        level_of_tile(cell.box_tile) > frames.tile_frame(from).position.level)
      return true;
    const int to = directory(cell.tile);
    return to != from && (to < 0 || (subcycling.part + 1) % subcycling.period(to) != 0);
  }
};

}  // namespace

bool find_early_arrivals(
    const Grid& grid, const std::vector<Particles>& sets, const Subcycling& subcycling
) {
  const Region region("find_early_arrivals");
  int early = 0;
  for (const Particles& particles : sets) {
    const IsEarly is_early{
        CellLattice(grid),
        RowFrames(grid, particles),
        particles.position.values,
        particles.fault,
        grid.directory,
        grid.level_of_tile,
        subcycling,
        {grid.lower[0], grid.lower[1], grid.lower[2]},
        {grid.upper[0], grid.upper[1], grid.upper[2]}};
    const ArrayView<unsigned char> chunk_part = particles.chunk_part;
    int found = 0;
    launch_reduction(
        "find_early_arrivals",
        range(particles.count),
        KOKKOS_LAMBDA(const int p, int& sum) {
          if (chunk_part(p / rows_per_chunk) != no_part_of_chunk) sum += is_early(p) ? 1 : 0;
        },
        found
    );
    early += found;
  }
  return early > 0;
}

}  // namespace barreno
