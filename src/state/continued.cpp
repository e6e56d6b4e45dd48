// SPDX-License-Identifier: BSD-3-Clause
#include "state/continued.hpp"

#include "shape/visit_kernels.hpp"
#include "state/bodies/body_particles.hpp"
#include "state/isolated_courant.hpp"

#include <algorithm>

namespace barreno {

void bound_steps(const Scene& scene, const Continued& continued, State& state) {
  constexpr double round_off = 1e-9;
  for (Particles& particles : state.particles) {
    const int m = particles.material;
    const double half = continued.half_sizes[static_cast<std::size_t>(m)] / scene.grid.cell_size;
    // Particles as the deck itself would make them keep the step that they would have.
    if (half == 0.0 || half >= (1.0 - round_off) * smallest_half_size(scene, m)) continue;
    const double critical = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(half);
    });
    particles.critical_courant = std::min(particles.critical_courant, critical);
    particles.isolated_courant =
        std::min(particles.isolated_courant, isolated_courant(scene, m, half));
  }
}

}  // namespace barreno
