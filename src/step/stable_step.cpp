// SPDX-License-Identifier: BSD-3-Clause
#include "step/stable_step.hpp"

#include "base/gather.hpp"
#include "base/interrupt.hpp"
#include "base/region.hpp"
#include "state/step_rule.hpp"
#include "step/surface_pressures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace barreno {

double stable_step_of_rows(const Scene& scene, const Particles& particles, int first_row) {
  const StepRule rule(scene, particles.critical_courant, particles.lone_courant);
  double step = std::numeric_limits<double>::infinity();
  for (int p = first_row; p < particles.count; ++p) {
    const double density = particles.mass(p) / particles.volume(p);
    const Vector v = vector_of(particles.velocity, p);
    const double speed = std::hypot(v[0], v[1], v[2]);
    step = std::min(step, rule.stable_step(density, particles.longitudinal_modulus(p), 0.0, speed));
  }
  return step;
}

double damped_step(double dt, double damping, double fraction) {
  if (damping == 0.0) return dt;
  return 4.0 * fraction / (damping + std::hypot(damping, 4.0 * fraction / dt));
}

double agree_on_step(const Scene& scene, double next_time, Placement& placement, State& state) {
  const Region region("agree_on_step");
  std::array<double, 4> flags{
      -state.stable_step,
      placement.someone_left ? 1.0 : 0.0,
      placement.new_tile ? 1.0 : 0.0,
      static_cast<double>(received_signal())};
  max_over_ranks(*state.grid.comm, flags);
  placement = {flags[1] > 0.0, flags[2] > 0.0, static_cast<int>(flags[3])};

  const StepSpec& spec = scene.step;
  double dt = stable_step_with_fluids(scene, state, -flags[0]);
  dt = damped_step(dt, spec.damping, spec.courant_fraction);
  if (state.clock.step == 0 && spec.initial_step > 0.0) dt = std::min(dt, spec.initial_step);
  if (state.clock.dt > 0.0) dt = std::min(dt, spec.growth_limit * state.clock.dt);
  if (spec.largest_step > 0.0) dt = std::min(dt, spec.largest_step);
  const double left = next_time - state.clock.time;
  if (dt >= left) return left;
  // Two even steps rather than a whole one and a sliver.
  return 2.0 * dt > left ? 0.5 * left : dt;
}

}  // namespace barreno
