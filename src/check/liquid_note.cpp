// SPDX-License-Identifier: BSD-3-Clause
#include "check/liquid_note.hpp"

#include "base/format.hpp"
#include "deck/section_table.hpp"
#include "scene/materials/liquids.hpp"

#include <cmath>

namespace barreno {

std::string liquid_note(const Scene& scene) {
  constexpr double equal = 1e-6;  // of the larger pressure: written in other units
  for (const PressureLoadSpec& load : scene.loads) {
    if (load.body < 0 || load.kind != LoadKind::pressure) continue;
    const BodySpec& body = scene.bodies[static_cast<std::size_t>(load.body)];
    if (!is_liquid(scene.materials[static_cast<std::size_t>(body.material)])) continue;
    const double own = body.initial_pressure, from_outside = load.pressure(0.0);
    if (std::fabs(own - from_outside) <= equal * std::fmax(own, from_outside)) continue;
    return list_of<BodySpec>(body.name) +
           format(" is a liquid that starts under %.4g MPa, and ", 1e-6 * own) +
           list_of<PressureLoadSpec>(load.name) +
           format(
               " presses on it with %.4g MPa: it does not start at rest; give its material this "
               "Initial Pressure if it should",
               1e-6 * from_outside
           );
  }
  return {};
}

}  // namespace barreno
