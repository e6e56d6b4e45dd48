// SPDX-License-Identifier: BSD-3-Clause
#include "step/stable_step.hpp"

#include "base/gather.hpp"
#include "base/interrupt.hpp"
#include "base/region.hpp"
#include "base/rows.hpp"
#include "step/cell_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace barreno {
namespace {

/// What the ranks agree on: of each the largest.
std::array<double, 4> sent_of(double stable_step, const Placement& placement) {
  return {
      -stable_step,
      placement.someone_left ? 1.0 : 0.0,
      placement.new_tile ? 1.0 : 0.0,
      static_cast<double>(received_signal())};
}
template <class Values>
Placement placement_of(const Values& agreed) {
  return {agreed[1] > 0.0, agreed[2] > 0.0, static_cast<int>(agreed[3])};
}

}  // namespace

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
  const bool by_cells = decides_by_cells(particles);
  const CellStepRule alone(spec, grid.mode, particles);
  launch_reduction(
      "stable_step_of_rows",
      range({first_row, particles.count}),
      KOKKOS_LAMBDA(const int p, double& part) {
        const double z = dimensions == 3 ? velocity(p, 2) : 0.0;
        const double speed = std::hypot(velocity(p, 0), velocity(p, 1), z);
        const double density = mass(p, 0) / volume(p, 0);
        const double step = by_cells
                                ? alone.of_row(p, cell_size)
                                : rule.stable_step(cell_size, density, modulus(p, 0), 0.0, speed);
        part = step < part ? step : part;
      },
      Kokkos::Min<double>(least)
  );
  return least;
}

double stable_step_of_cells(const StepSpec& spec, const Grid& grid, const Particles& particles) {
  double least = 0.0;
  const CellStepRule rule(spec, grid.mode, particles);
  const ArrayView<TileFrame> frame = grid.tile_frame;
  launch_reduction(
      "stable_step_of_cells",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile, double& part) {
        const double of_tile = rule.of_tile(tile, frame(tile).cell_size);
        part = of_tile < part ? of_tile : part;
      },
      Kokkos::Min<double>(least)
  );
  // The least of none is the largest double.
  constexpr auto largest = std::numeric_limits<double>::max();
  return least < largest ? least : std::numeric_limits<double>::infinity();
}

double damped_step(double dt, double damping, double fraction) {
  if (damping == 0.0) return dt;
  return 4.0 * fraction / (damping + std::hypot(damping, 4.0 * fraction / dt));
}

double agree_on_stable_step(
    const Teuchos::Comm<int>& comm, double stable_step, Placement& placement
) {
  const Region region("agree_on_stable_step");
  std::array<double, 4> agreed = sent_of(stable_step, placement);
  max_over_ranks(comm, agreed);
  placement = placement_of(agreed);
  return -agreed[0];
}

double agree_on_stable_step(
    const Teuchos::Comm<int>& comm,
    const std::vector<Particles>& sets,
    double stable_step,
    std::vector<double>& agreed,
    Placement& placement,
    int& set
) {
  const Region region("agree_on_stable_step");
  const std::array<double, 4> of_all = sent_of(stable_step, placement);
  agreed.assign(of_all.begin(), of_all.end());
  const std::size_t first = agreed.size();
  for (const Particles& particles : sets) agreed.push_back(-particles.stable_step);
  max_over_ranks(comm, agreed);
  placement = placement_of(agreed);
  set = -1;
  for (std::size_t s = 0; s < sets.size() && set < 0; ++s)
    if (agreed[first + s] == agreed[0]) set = static_cast<int>(s);
  return -agreed[0];
}

NextStep next_step(const StepSpec& spec, const Clock& clock, double next_time, double stable_step) {
  NextStep next{damped_step(stable_step, spec.damping, spec.courant_fraction), StepRule::stable};
  const auto limit = [&](double dt, StepRule rule) {
    if (dt < next.dt) next = {dt, rule};
  };
  if (clock.step == 0 && spec.initial_step > 0.0) limit(spec.initial_step, StepRule::largest);
  if (clock.dt > 0.0) limit(spec.growth_limit * clock.dt, StepRule::growth);
  if (spec.largest_step > 0.0) limit(spec.largest_step, StepRule::largest);
  const double left = next_time - clock.time;
  if (next.dt >= left) return {left, StepRule::event};
  // Two even steps rather than a whole one and a sliver.
  return 2.0 * next.dt > left ? NextStep{0.5 * left, StepRule::event} : next;
}

}  // namespace barreno
