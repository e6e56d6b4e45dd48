// SPDX-License-Identifier: BSD-3-Clause
#include "scene/dormant.hpp"

#include <algorithm>

namespace barreno {
namespace {

/// The force of a load on a particle at rest does not change as time goes on.
bool is_steady(const PressureLoadSpec& load) {
  return traits_of(load.kind).steady && load.pressure.time.size() <= 1;
}

}  // namespace

std::string why_all_awake(const Scene& scene) {
  if (scene.step.order != Order::stress_last)
    return std::string("Order is ") + word_of(scene.step.order) + ", which visits all tiles twice";
  if (scene.step.transfer == Transfer::xpic)
    return "Transfer is XPIC, which visits all tiles several times";
  if (scene.step.transfer == Transfer::apic)
    return "Transfer is APIC, whose particles carry more than a velocity";
  if (scene.body_force.kind != BodyForceKind::none) return "a body force acts on all particles";
  if (scene.pore_flow.on()) return "pore fluid flows through all rock";
  if (!std::all_of(scene.loads.begin(), scene.loads.end(), is_steady))
    return "a load changes with time";
  return {};
}

double rest_motion(const Scene& scene) {
  if (scene.step.rest_motion) return *scene.step.rest_motion;
  const bool stressed =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodySpec& body) {
        return body.initial_pressure != 0.0;
      });
  return stressed ? stressed_rest_motion : 0.0;
}

}  // namespace barreno
