// SPDX-License-Identifier: BSD-3-Clause
#include "step/move_rigid.hpp"

#include "base/region.hpp"
#include "scene/rigid_velocity.hpp"
#include "scene/velocity_fields.hpp"

#include <cmath>
#include <limits>

namespace barreno {

double move_rigid(const Scene& scene, const Clock& clock, double dt, Particles& particles) {
  const Region region("move_rigid");
  const int body = rigid_body_of(scene, particles.material);
  const Vector v = rigid_velocity(scene.bodies[static_cast<std::size_t>(body)], clock.time, dt);
  double squared = 0.0;
  for (int d = 0; d < particles.position.components; ++d) {
    const double component = v[static_cast<std::size_t>(d)];
    for (int p = 0; p < particles.count; ++p) {
      particles.velocity(p, d) = component;
      particles.position(p, d) += dt * component;
    }
    squared += component * component;
  }
  return squared > 0.0 ? 0.5 * scene.grid.cell_size / std::sqrt(squared)
                       : std::numeric_limits<double>::infinity();
}

}  // namespace barreno
