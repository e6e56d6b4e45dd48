// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads/load_pressures.hpp"

#include "base/error.hpp"
#include "base/launch.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace barreno {
namespace {

[[noreturn]] void refuse_closed(const std::string& name) {
  std::ostringstream text;
  text << "The cavity of Loads/" << name
       << " has closed: its fluid has no volume left. Raise Bulk Modulus or load the body less.";
  throw NumericalError(text.str());
}

}  // namespace

double load_pressure(const PressureLoadSpec& load, const Cavity& cavity, double time) {
  double pressure = load.pressure(time);
  if (cavity.holds_fluid()) {
    const double ratio = cavity.volume / cavity.initial_volume;
    if (!(ratio > 0.0)) refuse_closed(load.name);
    pressure -= cavity.bulk_modulus * std::log(ratio);
  }
  return pressure;
}

void set_load_pressures(
    const std::vector<PressureLoadSpec>& specs,
    const std::vector<Cavity>& cavities,
    double time,
    const LoadTable& loads
) {
  for (std::size_t l = 0; l < specs.size(); ++l) {
    const double pressure = load_pressure(specs[l], cavities[l], time);
    launch(
        "set_load_pressures",
        range(1),
        KOKKOS_LAMBDA(const int) { loads.loads(l).pressure = pressure; }
    );
  }
}

double stable_step_with_fluids(const std::vector<Cavity>& cavities, double cell_size, double dt) {
  double step = dt;
  for (const Cavity& cavity : cavities) {
    if (!cavity.holds_fluid()) continue;
    const double powers = cavity.powers;
    const double ratio = cavity.volume / cavity.initial_volume;
    const double radius = cavity.initial_radius * std::pow(std::max(ratio, 0.0), 1.0 / powers);
    const double square =
        8.0 * powers * cavity.bulk_modulus / (cavity.wall_density * radius * cell_size);
    step = std::min(step, dt / std::sqrt(1.0 + 0.25 * square * dt * dt));
  }
  return step;
}

}  // namespace barreno
