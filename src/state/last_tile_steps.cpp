// SPDX-License-Identifier: BSD-3-Clause
#include "state/last_tile_steps.hpp"

#include "base/gather.hpp"

namespace barreno {
namespace {

/// Whether an active tile held a particle when the particles were last sorted. Which empty tiles
/// are active depends on how long the run has gone on without a resume, so nothing is kept of them.
std::vector<char> occupied_tiles(const State& state) {
  std::vector<char> occupied(static_cast<std::size_t>(state.grid.active), 0);
  for (const Particles& particles : state.particles) {
    if (particles.tile_begin.extent(0) < occupied.size() + 1) continue;
    const auto begin =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.tile_begin);
    for (std::size_t tile = 0; tile < occupied.size(); ++tile)
      if (begin(tile + 1) > begin(tile)) occupied[tile] = 1;
  }
  return occupied;
}

}  // namespace

std::vector<double> last_tile_steps(const State& state) {
  if (!state.resumed_tile_steps.empty()) return state.resumed_tile_steps;
  const Grid& grid = state.grid;
  const auto tiles = static_cast<std::size_t>(grid.box.first_id[grid.box.levels]);
  const bool alike = state.subcycling.most == 1;
  std::vector<double> steps(tiles, alike ? state.clock.dt : 0.0);
  if (alike) return steps;
  const auto frame = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), grid.tile_frame);
  const std::vector<char> occupied = occupied_tiles(state);
  for (int tile = 0; tile < grid.active; ++tile)
    if (occupied[static_cast<std::size_t>(tile)] != 0)
      steps[static_cast<std::size_t>(grid.box.id(frame(tile).position))] = frame(tile).dt;
  max_over_ranks(*grid.comm, steps);
  return steps;
}

}  // namespace barreno
