// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/quasi_static_section.hpp"
#include "geometry/piece.hpp"
#include "scene/build_scene.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/models.hpp>
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
    const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material();
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
      "cannot be combined with Quasi-Static (which scales inertia, so that inertial motion would "
      "be wrong); remove one of the two";
  if (scene.jet.present) deck.refuse(table_of<JetSpec>().path, why);
  const BodyForceKind force = scene.body_force.kind;
  if (force != BodyForceKind::none && force != BodyForceKind::gravity)
    deck.refuse_value(path_of(&BodyForceSpec::kind), why);
  for (const BodySpec& body : scene.bodies)
    for (const std::string& path :
         {path_of(&BodySpec::velocity, body.name),
          path_of(&BodySpec::spin, body.name),
          path_of(&BodySpec::radial_velocity, body.name)})
      if (deck.has(path) && !body.motion.prescribed) deck.refuse_value(path, why);
}

}  // namespace

void add_quasi_static(const Deck& deck, Scene& scene) {
  if (!deck.has(path_of(&QuasiStaticSection::transit_ratio))) return;
  const auto said = read_section<QuasiStaticSection>(deck);
  refuse_motion(deck, scene);
  const double side = longest_side(scene);
  if (!(side > 0.0))
    deck.refuse(
        table_of<QuasiStaticSection>().path,
        "has no body that deforms; remove the list or add a body"
    );
  QuasiStaticSpec& quasi_static = scene.quasi_static;
  const double diffused = drained_length(scene) / side;
  quasi_static.slow_time = scene.end_time / std::max(1.0, diffused * diffused);
  const double transit = side / slowest_wave(scene);
  double root = said.transit_ratio * quasi_static.slow_time / transit;
  if (said.inertia_factor) root = std::sqrt(*said.inertia_factor);
  root = std::max(1.0, root);
  quasi_static.inertia_factor = root * root;
  quasi_static.transit_time = root * transit;
  // Twice the angular frequency of a column's slowest wave, four lengths long: critical.
  if (scene.step.damping == 0.0) scene.step.damping = std::acos(-1.0) / quasi_static.transit_time;
  for (MaterialSpec& spec : scene.materials) spec.scale_density(quasi_static.inertia_factor);
  for (double& a : scene.body_force.acceleration) a /= quasi_static.inertia_factor;
}

}  // namespace barreno
