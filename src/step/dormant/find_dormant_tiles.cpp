// SPDX-License-Identifier: BSD-3-Clause
#include "step/dormant/find_dormant_tiles.hpp"

#include "base/region.hpp"
#include "base/rows.hpp"
#include "step/stable_step_rule.hpp"

#include <limits>

namespace barreno {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Arrays for the tiles that the grid has now; what was known of others is forgotten. Whether sums
/// are kept is one thing for all fields.
void start_afresh(const Grid& grid, Dormancy& dormancy, std::vector<Nodes>& fields) {
  if (dormancy.activation == grid.activations) return;
  dormancy.activation = grid.activations;
  const auto tiles = static_cast<std::size_t>(grid.active);
  if (dormancy.rows.extent(0) < tiles) {
    const std::size_t room = tiles + tiles / 4;
    dormancy.candidate = ArrayView<unsigned char>("dormant_candidate", room);
    dormancy.motionless = ArrayView<unsigned char>("motionless", room);
    dormancy.unsolved = ArrayView<unsigned char>("unsolved", room);
    dormancy.dormant = ArrayView<unsigned char>("dormant", room);
    dormancy.stays = ArrayView<unsigned char>("stays", room);
    dormancy.rows = ArrayView<int>("rows", room);
    dormancy.summed_rows = ArrayView<int>("summed_rows", room);
    dormancy.speed = ArrayView<double>("node_speed", room);
    dormancy.acceleration = ArrayView<double>("node_acceleration", room);
    dormancy.step = ArrayView<double>("dormant_step", room);
    const ArrayView<unsigned char> sums_kept("sums_kept", room);
    for (Nodes& nodes : fields) nodes.sums_kept = sums_kept;
  }
  Kokkos::deep_copy(dormancy.summed_rows, 0);
}

/// Where a symmetry plane across y is within reach of a tile, its sums are no longer those of its
/// particles (mirror_sums).
struct AxialPlanes {
  ArrayView<TileFrame> frame;
  Patch patch;
  bool at_lower, at_upper;
  int last;  ///< node of the upper face

  explicit AxialPlanes(const Grid& grid)
      : frame(grid.tile_frame),
        patch(grid.patch),
        at_lower(grid.mirrored[static_cast<std::size_t>(Face::y_lower)]),
        at_upper(grid.mirrored[static_cast<std::size_t>(Face::y_upper)]),
        last(grid.cells[1]) {}
  KOKKOS_INLINE_FUNCTION bool reaches(int tile) const {
    const TilePosition& at = frame(tile).position;
    const int first = at[1] * patch.tile_cells - patch.reach;
    return (at_lower && first < 0) || (at_upper && first + patch.nodes - 1 > last << at.level);
  }
};

/// Counts the rows of a set in each tile. A tile is not a candidate if a row moves: if it has a
/// velocity, or a viscous pressure, which would vanish in the step, or burns until `horizon`.
void look_at_rows(
    int tiles,
    const Particles& particles,
    const Subcycling& subcycling,
    const Dormancy& dormancy,
    double horizon
) {
  const FieldView history = particles.history.values;
  const BurnColumns columns = particles.burn_columns;
  const ArrayView<int> tile_begin = particles.tile_begin, order = particles.order;
  const FieldView velocity = particles.velocity.values;
  const FieldView viscous = particles.viscous_pressure.values;
  const int dimensions = particles.velocity.components;
  launch(
      "look_at_rows",
      range(tiles),
      KOKKOS_LAMBDA(const int tile) {
        if (!subcycling.starts(tile)) return;
        const int begin = tile_begin(tile), end = tile_begin(tile + 1);
        dormancy.rows(tile) += end - begin;
        bool moves = dormancy.candidate(tile) == 0;
        for (int k = begin; k < end && !moves; ++k) {
          const int p = order(k);
          moves = viscous(p, 0) != 0.0;
          for (int d = 0; d < dimensions; ++d) moves = moves || velocity(p, d) != 0.0;
          if (columns.burns())
            moves =
                moves || (history(p, columns.lighting) < horizon && history(p, columns.burn) < 1.0);
        }
        if (moves) dormancy.candidate(tile) = 0;
      }
  );
}

/// Coarser tiles have the rows of the finer ones in them, and rest with them. They begin a step
/// whenever one of those does.
void add_finer_tiles(const Grid& grid, const Subcycling& subcycling, const Dormancy& dormancy) {
  const ArrayView<int> parent = grid.parent;
  for (int level = grid.box.levels - 1; level > 0; --level)
    launch(
        "add_finer_tiles",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        KOKKOS_LAMBDA(const int tile) {
          if (!subcycling.starts(parent(tile))) return;
          fetch_add(dormancy.rows(parent(tile)), dormancy.rows(tile));
          if (dormancy.candidate(tile) == 0) dormancy.candidate(parent(tile)) = 0;
        }
    );
}

/// A coarser tile's sums are those of the finer ones in it: they hold where all of theirs do.
void keep_with_finer_tiles(
    const Grid& grid, const Subcycling& subcycling, const ArrayView<unsigned char>& sums_kept
) {
  const ArrayView<int> parent = grid.parent;
  for (int level = grid.box.levels - 1; level > 0; --level)
    launch(
        "keep_with_finer_tiles",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        KOKKOS_LAMBDA(const int tile) {
          if (subcycling.starts(parent(tile)) && sums_kept(tile) != sums_as_were)
            sums_kept(parent(tile)) = sums_afresh;
        }
    );
}

/// A tile's least stable step, as far as this set has it, which changes only with its particles:
/// what update_stress would find without it.
void take_stable_steps(
    const StableStepRule& rule,
    const Grid& grid,
    const Particles& particles,
    const Dormancy& dormancy
) {
  const ArrayView<TileFrame> frame = grid.tile_frame;
  const ArrayView<int> tile_begin = particles.tile_begin, order = particles.order;
  const ArrayView<int> body = particles.body;
  const FieldView mass = particles.mass.values, volume = particles.volume.values;
  const FieldView modulus = particles.longitudinal_modulus.values;
  launch(
      "take_stable_steps",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (dormancy.summed_rows(tile) >= 0) return;
        double least = dormancy.step(tile);
        for (int k = tile_begin(tile); k < tile_begin(tile + 1); ++k) {
          const int p = order(k);
          if ((body(p) & debris_bit) != 0) continue;
          const double density = mass(p, 0) / volume(p, 0);
          const double step =
              rule.stable_step(frame(tile).cell_size, density, modulus(p, 0), 0.0, 0.0);
          least = step < least ? step : least;
        }
        dormancy.step(tile) = least;
      }
  );
}

/// Which rows of which chunks are in tiles that stay as they are.
/// @return the rows that are skipped
int find_chunk_parts(const Patch& patch, const Dormancy& dormancy, Particles& particles) {
  particles.settled_chunks = particles.count / rows_per_chunk;
  int skipped = 0;
  launch_reduction(
      "find_chunk_parts",
      range((particles.count + rows_per_chunk - 1) / rows_per_chunk),
      KOKKOS_LAMBDA(const int chunk, int& sum) {
        const int begin = chunk * rows_per_chunk;
        const int left = particles.count - begin;
        const int end = begin + (left < rows_per_chunk ? left : rows_per_chunk);
        int stay = 0;
        bool skips = true;
        for (int p = begin; p < end; ++p) {
          const unsigned char stays = dormancy.stays(tile_of(patch, particles, p));
          particles.dormant(p) = stays;
          stay += stays != moves ? 1 : 0;
          skips = skips && (stays == is_in_its_step || (stays == is_dormant_tile && dormancy.skip));
        }
        particles.chunk_part(chunk) = skips      ? no_part_of_chunk
                                      : stay > 0 ? part_of_chunk
                                                 : whole_chunk;
        if (skips) sum += stay;
      },
      skipped
  );
  return skipped;
}

}  // namespace

void find_dormant_candidates(
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Subcycling& subcycling,
    Dormancy& dormancy,
    std::vector<Nodes>& fields,
    Effort& effort,
    double horizon
) {
  if (!dormancy.on) return;
  const Region region("find_dormant_candidates");
  const Stopwatch watch;
  start_afresh(grid, dormancy, fields);
  const Dormancy of = dormancy;
  launch(
      "clear_candidates",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (!subcycling.starts(tile)) return;
        of.rows(tile) = 0;
        of.candidate(tile) = 1;
      }
  );
  for (const Particles& particles : sets)
    look_at_rows(grid.active, particles, subcycling, dormancy, horizon);
  add_finer_tiles(grid, subcycling, dormancy);
  const ArrayView<unsigned char> sums_kept = fields.front().sums_kept;
  const AxialPlanes planes(grid);
  launch(
      "find_dormant_candidates",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (!subcycling.starts(tile)) {
          sums_kept(tile) = subcycling.gained(tile) != 0 ? sums_gaining : sums_as_were;
          return;
        }
        if (of.rows(tile) == 0) of.candidate(tile) = 0;
        const bool kept = of.candidate(tile) != 0 && of.summed_rows(tile) == of.rows(tile) &&
                          !planes.reaches(tile);
        sums_kept(tile) = kept ? sums_as_were : sums_afresh;
      }
  );
  keep_with_finer_tiles(grid, subcycling, sums_kept);
  effort.tile_seconds += watch.seconds();
}

void find_dormant_tiles(
    const StepSpec& step,
    const Clock& clock,
    const Grid& grid,
    std::vector<Particles>& sets,
    const Subcycling& subcycling,
    Dormancy& dormancy
) {
  if (!dormancy.on) return;
  const Region region("find_dormant_tiles");
  // The first update settles what a material makes of its initial state: nobody misses it.
  const bool first = clock.step == 0;
  const bool skips = dormancy.skip && !first;
  const Dormancy of = dormancy;
  launch(
      "find_dormant_tiles",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        const bool dormant = of.candidate(tile) != 0 && of.motionless(tile) != 0;
        of.dormant(tile) = dormant ? 1 : 0;
        const bool ends = !subcycling.on() || subcycling.ends(tile) != 0;
        of.stays(tile) = !ends ? is_in_its_step : dormant ? is_dormant_tile : moves;
        if (!ends) return;
        // What a step of several parts has added to the momenta is in no particle of a dormant
        // tile.
        const bool as_summed = !subcycling.on() || subcycling.gained(tile) == 0;
        const int rows = dormant && skips && as_summed ? of.rows(tile) : 0;
        const bool known = rows == 0 || rows == of.summed_rows(tile);
        of.summed_rows(tile) = known ? rows : -rows;  // below 0 until their step is known
        if (!known) of.step(tile) = infinite;
      }
  );
  for (const Particles& particles : sets) {
    if (particles.rigid) continue;
    const StableStepRule rule(
        step, grid.mode, particles.critical_courant, particles.isolated_courant
    );
    take_stable_steps(rule, grid, particles, dormancy);
  }
  double least_step = infinite;
  launch_reduction(
      "dormant_stable_step",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile, double& least) {
        const int rows = of.summed_rows(tile);
        if (rows != 0 && of.step(tile) < least) least = of.step(tile);
        of.summed_rows(tile) = rows < 0 ? -rows : rows;
      },
      Kokkos::Min<double>(least_step)
  );
  // Without a dormant tile the reduction leaves the largest number.
  dormancy.stable_step = least_step;
  if (least_step >= std::numeric_limits<double>::max()) dormancy.stable_step = infinite;
  dormancy.skipped_rows = 0;
  if (first) return;
  for (Particles& particles : sets)
    dormancy.skipped_rows += find_chunk_parts(grid.patch, dormancy, particles);
}

}  // namespace barreno
