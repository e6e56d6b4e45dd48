// SPDX-License-Identifier: BSD-3-Clause
#include "step/find_dormant_tiles.hpp"

#include "base/region.hpp"
#include "base/rows.hpp"
#include "step/mirror_walls.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// Arrays for the tiles that the grid has now; what was known of others is forgotten.
void start_afresh(const Grid& grid, Dormancy& dormancy, Nodes& nodes) {
  if (dormancy.activation == grid.activations) return;
  dormancy.activation = grid.activations;
  const auto tiles = static_cast<std::size_t>(grid.active);
  if (dormancy.rows.extent(0) < tiles) {
    const std::size_t room = tiles + tiles / 4;
    dormancy.rests = ArrayView<unsigned char>("rests", room);
    dormancy.dormant = ArrayView<unsigned char>("dormant", room);
    dormancy.rows = ArrayView<int>("dormant_rows", room);
    nodes.kept = ArrayView<unsigned char>("kept", room);
  }
  Kokkos::deep_copy(dormancy.rows, 0);
}

int rows_in(const State& state, int tile) {
  int rows = 0;
  for (const Particles& particles : state.particles)
    rows += particles.tile_begin(tile + 1) - particles.tile_begin(tile);
  return rows;
}

/// No velocity, and no viscous pressure, which would go at once.
bool is_at_rest(const Particles& particles, int tile) {
  for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
    const int p = particles.order(k);
    if (particles.viscous_pressure(p) != 0.0) return false;
    for (int d = 0; d < particles.velocity.components; ++d)
      if (particles.velocity(p, d) != 0.0) return false;
  }
  return true;
}
bool is_at_rest(const State& state, int tile) {
  for (const Particles& particles : state.particles)
    if (!is_at_rest(particles, tile)) return false;
  return true;
}

/// Neither the velocity after the step nor its increment is above a limit at any node of the tile.
bool is_still(const Patch& patch, const Nodes& nodes, int tile, double limit) {
  const int count = patch.size * motion_components(patch.dimensions);
  const double* const motion = &nodes.motion(first_motion(patch, tile));
  int moves = 0;
  for (int i = 0; i < count; ++i) moves |= static_cast<int>(!(std::abs(motion[i]) <= limit));
  return moves == 0;
}

/// Which rows of which runs are in dormant tiles.
/// @return the rows that are skipped
int find_run_parts(const Patch& patch, const Dormancy& dormancy, const Particles& particles) {
  const int bits = patch.tile_bits * patch.dimensions;
  int skipped = 0;
  for (int begin = 0; begin < particles.count; begin += rows_per_run) {
    const int end = std::min(begin + rows_per_run, particles.count);
    int left_out = 0;
    for (int p = begin; p < end; ++p) {
      particles.left_out(p) = dormancy.dormant(particles.key(p) >> bits);
      left_out += particles.left_out(p);
    }
    const bool skips = dormancy.skips && left_out == end - begin;
    particles.run_part(begin / rows_per_run) = skips          ? no_part_of_run
                                               : left_out > 0 ? part_of_run
                                                              : whole_run;
    if (skips) skipped += left_out;
  }
  return skipped;
}

}  // namespace

void find_resting_tiles(const Scene& scene, State& state) {
  Dormancy& dormancy = state.dormancy;
  if (!dormancy.on) return;
  const Region region("find_resting_tiles");
  Nodes& nodes = state.nodes.front();
  start_afresh(state.grid, dormancy, nodes);
  for (int tile = 0; tile < state.grid.active; ++tile) {
    const int rows = rows_in(state, tile);
    const bool rests = rows > 0 && is_at_rest(state, tile);
    dormancy.rests(tile) = rests ? 1 : 0;
    nodes.kept(tile) =
        rests && dormancy.rows(tile) == rows && !is_mirrored_along_axis(scene, state.grid, tile)
            ? 1
            : 0;
  }
}

void find_dormant_tiles(const Scene& scene, double dt, State& state) {
  Dormancy& dormancy = state.dormancy;
  if (!dormancy.on) return;
  const Region region("find_dormant_tiles");
  const double limit = dormancy.motion * scene.grid.cell_size / dt;
  // The first update settles what a material makes of its initial state: nobody misses it.
  const bool first = state.clock.step == 0;
  for (int tile = 0; tile < state.grid.active; ++tile) {
    const bool dormant =
        dormancy.rests(tile) != 0 && is_still(state.grid.patch, state.nodes.front(), tile, limit);
    dormancy.dormant(tile) = dormant ? 1 : 0;
    dormancy.rows(tile) = dormant && dormancy.skips && !first ? rows_in(state, tile) : 0;
  }
  dormancy.skipped = 0;
  if (first) return;
  for (const Particles& particles : state.particles)
    dormancy.skipped += find_run_parts(state.grid.patch, dormancy, particles);
}

}  // namespace barreno
