// SPDX-License-Identifier: BSD-3-Clause
#include "step_cost.hpp"

#include "base/region.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace barreno {

Cost time_steps(const Scene& scene, int steps) {
  State state = testing::start(scene);
  testing::advance_to(scene, 1.0, state, 20);
  std::vector<double> seconds;
  clear_phase_times();
  const double before = state.particle_steps;
  for (int block = 0; block < 5; ++block) {
    const auto start = std::chrono::steady_clock::now();
    testing::advance_to(scene, 1.0, state, steps);
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()
    );
  }
  std::sort(seconds.begin(), seconds.end());
  const double particle_steps = (state.particle_steps - before) / 5.0;
  return {
      seconds[2] / particle_steps * 1e9,
      seconds[0] / particle_steps * 1e9,
      static_cast<double>(bytes_per_particle(state.particles.front())),
      least_work(scene, state)};
}

}  // namespace barreno
