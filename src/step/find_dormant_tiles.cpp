// SPDX-License-Identifier: BSD-3-Clause
#include "step/find_dormant_tiles.hpp"

#include "base/region.hpp"
#include "base/rows.hpp"
#include "state/step_rule.hpp"
#include "step/mirror_walls.hpp"

#include <algorithm>
#include <limits>

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
    dormancy.still = ArrayView<unsigned char>("still", room);
    dormancy.speed = ArrayView<double>("resting_speed", room);
    dormancy.acceleration = ArrayView<double>("resting_acceleration", room);
    dormancy.step = ArrayView<double>("dormant_step", room);
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

/// The least stable step of a tile's particles, which changes only with them: what update_stress
/// would find without it.
double stable_step_of(const Scene& scene, const State& state, int tile) {
  double step = std::numeric_limits<double>::infinity();
  for (const Particles& particles : state.particles) {
    if (particles.rigid) continue;
    const StepRule rule(scene, particles.critical_courant, particles.lone_courant);
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      if ((particles.body(p) & held_bit) != 0) continue;
      const double density = particles.mass(p) / particles.volume(p);
      step = std::min(step, rule.stable_step(density, particles.longitudinal_modulus(p), 0.0, 0.0));
    }
  }
  return step;
}

/// Which rows of which runs are in dormant tiles.
/// @return the rows that are skipped
int find_run_parts(const Patch& patch, const Dormancy& dormancy, const Particles& particles) {
  int skipped = 0;
  for (int begin = 0; begin < particles.count; begin += rows_per_run) {
    const int end = std::min(begin + rows_per_run, particles.count);
    int left_out = 0;
    for (int p = begin; p < end; ++p) {
      particles.left_out(p) = dormancy.dormant(tile_of(patch, particles, p));
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
  const Stopwatch watch;
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
  state.effort.tile_seconds += watch.seconds();
}

void find_dormant_tiles(const Scene& scene, State& state) {
  Dormancy& dormancy = state.dormancy;
  if (!dormancy.on) return;
  const Region region("find_dormant_tiles");
  // The first update settles what a material makes of its initial state: nobody misses it.
  const bool first = state.clock.step == 0;
  dormancy.stable_step = std::numeric_limits<double>::infinity();
  for (int tile = 0; tile < state.grid.active; ++tile) {
    const bool dormant = dormancy.rests(tile) != 0 && dormancy.still(tile) != 0;
    dormancy.dormant(tile) = dormant ? 1 : 0;
    const int rows = dormant && dormancy.skips && !first ? rows_in(state, tile) : 0;
    if (rows > 0 && rows != dormancy.rows(tile))
      dormancy.step(tile) = stable_step_of(scene, state, tile);
    if (rows > 0) dormancy.stable_step = std::min(dormancy.stable_step, dormancy.step(tile));
    dormancy.rows(tile) = rows;
  }
  dormancy.skipped = 0;
  if (first) return;
  for (const Particles& particles : state.particles)
    dormancy.skipped += find_run_parts(state.grid.patch, dormancy, particles);
}

}  // namespace barreno
