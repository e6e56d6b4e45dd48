// SPDX-License-Identifier: BSD-3-Clause
#include "state/last_tile_steps.hpp"

#include "base/gather.hpp"

namespace barreno {

std::vector<double> last_tile_steps(const State& state) {
  if (!state.resumed_tile_steps.empty()) return state.resumed_tile_steps;
  const Grid& grid = state.grid;
  const auto tiles = static_cast<std::size_t>(grid.box.first_id[grid.box.levels]);
  const bool alike = state.subcycling.most == 1;
  std::vector<double> steps(tiles, alike ? state.clock.dt : 0.0);
  if (alike) return steps;
  const auto frame = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), grid.tile_frame);
  for (int tile = 0; tile < grid.active; ++tile)
    steps[static_cast<std::size_t>(grid.box.id(frame(tile).position))] = frame(tile).dt;
  max_over_ranks(*grid.comm, steps);
  return steps;
}

}  // namespace barreno
