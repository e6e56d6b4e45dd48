// SPDX-License-Identifier: BSD-3-Clause
#include "step/stable_step.hpp"

#include "base/gather.hpp"
#include "base/interrupt.hpp"
#include "base/region.hpp"
#include "base/rows.hpp"
#include "step/stable_step_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace barreno {

double stable_step_of_rows(
    const StepSpec& spec, const Grid& grid, const Particles& particles, int first_row
) {
  if (first_row == particles.count) return std::numeric_limits<double>::infinity();
  const StableStepRule rule(
      spec, grid.mode, particles.critical_courant, particles.isolated_courant
  );
  const FieldView mass = particles.mass.values, volume = particles.volume.values;
  const FieldView modulus = particles.longitudinal_modulus.values;
  const FieldView velocity = particles.velocity.values;
  const int dimensions = particles.velocity.components;
  const double cell_size = grid.smallest_cell();  // these rows are in no tile yet
  double least = 0.0;
  launch_reduction(
      "stable_step_of_rows",
      range({first_row, particles.count}),
      KOKKOS_LAMBDA(const int p, double& part) {
        const double z = dimensions == 3 ? velocity(p, 2) : 0.0;
        const double speed = std::hypot(velocity(p, 0), velocity(p, 1), z);
        const double density = mass(p, 0) / volume(p, 0);
        const double step = rule.stable_step(cell_size, density, modulus(p, 0), 0.0, speed);
        part = step < part ? step : part;
      },
      Kokkos::Min<double>(least)
  );
  return least;
}

double damped_step(double dt, double damping, double fraction) {
  if (damping == 0.0) return dt;
  return 4.0 * fraction / (damping + std::hypot(damping, 4.0 * fraction / dt));
}

double agree_on_stable_step(
    const Teuchos::Comm<int>& comm, double stable_step, Placement& placement
) {
  const Region region("agree_on_stable_step");
  std::array<double, 4> flags{
      -stable_step,
      placement.someone_left ? 1.0 : 0.0,
      placement.new_tile ? 1.0 : 0.0,
      static_cast<double>(received_signal())};
  max_over_ranks(comm, flags);
  placement = {flags[1] > 0.0, flags[2] > 0.0, static_cast<int>(flags[3])};
  return -flags[0];
}

double next_step(const StepSpec& spec, const Clock& clock, double next_time, double stable_step) {
  double dt = damped_step(stable_step, spec.damping, spec.courant_fraction);
  if (clock.step == 0 && spec.initial_step > 0.0) dt = std::min(dt, spec.initial_step);
  if (clock.dt > 0.0) dt = std::min(dt, spec.growth_limit * clock.dt);
  if (spec.largest_step > 0.0) dt = std::min(dt, spec.largest_step);
  const double left = next_time - clock.time;
  if (dt >= left) return left;
  // Two even steps rather than a whole one and a sliver.
  return 2.0 * dt > left ? 0.5 * left : dt;
}

}  // namespace barreno
