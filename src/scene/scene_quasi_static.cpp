// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "geometry/piece.hpp"
#include "scene/build_scene.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

/// Longest side of the box around all bodies that deform.
double longest_side(const Scene& scene) {
  Vector lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};
  for (const BodySpec& body : scene.bodies) {
    if (body.motion.prescribed) continue;
    const Box box = box_around(body.shape);
    for (std::size_t d = 0; d < 3; ++d) {
      lower[d] = std::min(lower[d], std::max(box.lower[d], scene.grid.lower[d]));
      upper[d] = std::max(upper[d], std::min(box.upper[d], scene.grid.upper[d]));
    }
  }
  double longest = 0.0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++d)
    longest = std::max(longest, upper[d] - lower[d]);
  return longest;
}

/// Of plane waves in the material where they are slowest, as it starts and with its true density.
double slowest_wave(const Scene& scene) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const BodySpec& body : scene.bodies) {
    if (body.motion.prescribed) continue;
    const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material;
    const double modulus = std::visit(
        [&](const auto& model) {
          const auto start = model.initial_state(body.initial_pressure);
          return model.longitudinal_modulus(start.stress, start.history, start.volume_ratio);
        },
        material.model
    );
    slowest = std::min(slowest, std::sqrt(modulus / material.density));
  }
  return slowest;
}

/// What moves at the start, or is thrown in, has a momentum that must not be scaled.
void refuse_motion(const Deck& deck, const Scene& scene) {
  const std::string why =
      "cannot be joined with Quasi-Static (inertia is scaled there, so that nothing may move by "
      "it); remove one of the two";
  if (scene.jet.present) deck.refuse("Jet", why);
  const BodyForceKind force = scene.body_force.kind;
  if (force != BodyForceKind::none && force != BodyForceKind::gravity)
    deck.refuse_value("Body Force/Kind", why);
  for (const BodySpec& body : scene.bodies)
    for (const char* entry : {"/Velocity", "/Spin", "/Radial Velocity"})
      if (deck.has("Bodies/" + body.name + entry) && !body.motion.prescribed)
        deck.refuse_value("Bodies/" + body.name + entry, why);
}

}  // namespace

void add_quasi_static(const Deck& deck, Scene& scene) {
  if (!deck.has("Quasi-Static/Transit Ratio")) return;
  refuse_motion(deck, scene);
  const double side = longest_side(scene);
  if (!(side > 0.0))
    deck.refuse("Quasi-Static", "has no body that deforms; remove the list or add a body");
  QuasiStaticSpec& quasi_static = scene.quasi_static;
  const double diffused = drained_length(scene) / side;
  quasi_static.slow_time = scene.end_time / std::max(1.0, diffused * diffused);
  const double transit = side / slowest_wave(scene);
  double root = deck.number("Quasi-Static/Transit Ratio") * quasi_static.slow_time / transit;
  if (deck.has("Quasi-Static/Inertia Factor"))
    root = std::sqrt(deck.number("Quasi-Static/Inertia Factor"));
  root = std::max(1.0, root);
  quasi_static.inertia_factor = root * root;
  quasi_static.transit_time = root * transit;
  // Twice the angular frequency of a column's slowest wave, four lengths long: critical.
  if (scene.step.damping == 0.0) scene.step.damping = std::acos(-1.0) / quasi_static.transit_time;
  for (MaterialSpec& spec : scene.materials) spec.material.density *= quasi_static.inertia_factor;
  for (double& a : scene.body_force.acceleration) a /= quasi_static.inertia_factor;
}

}  // namespace barreno
