// SPDX-License-Identifier: BSD-3-Clause
#include "predict_cost.hpp"

#include "base/memory.hpp"
#include "cost_growth.hpp"
#include "scene/build_scene.hpp"
#include "shape/shape_facts.hpp"
#include "shape/visit_kernels.hpp"
#include "state/body_particles.hpp"
#include "state/step_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace barreno {
namespace {

/// Compression of what collides, over the speed of its bodies: h |tr D| / v. Fits the steps of
/// shock_copper.xml, where the shocked metal is also stiffer.
constexpr double compression = 0.5;

double body_speed(const Scene& scene, int material) {
  double speed = 0.0;
  for (const BodySpec& body : scene.bodies)
    if (body.material == material)
      speed = std::max(
          speed,
          std::hypot(body.velocity[0], body.velocity[1], body.velocity[2]) +
              std::abs(body.radial_velocity)
      );
  return speed;
}

double jet_speed(const Scene& scene, int material) {
  double speed = 0.0;
  if (scene.jet.present && scene.jet.material == material)
    for (const JetSlug& slug : scene.jet.slugs) speed = std::max(speed, slug.velocity);
  return speed;
}

bool is_rigid(const Scene& scene, const BodySpec& body) {
  return scene.bodies.size() > 1 && body.motion.prescribed;
}

}  // namespace

double stable_step_of_scene(const Scene& scene, bool viscous) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const int index = static_cast<int>(m);
    const Material& material = scene.materials[m].material;
    const double courant = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(smallest_half_size(scene, index));
    });
    const double modulus = std::visit(
        [](const auto& model) {
          return model.longitudinal_modulus({}, model.initial_history(), 1.0);
        },
        material.model
    );
    const double slow = body_speed(scene, index), fast = std::max(slow, jet_speed(scene, index));
    // Any rate below zero brings the linear part; that of the colliding bodies the quadratic one.
    const double rate = viscous ? -(compression * slow + 1e-9) / scene.grid.cell_size : 0.0;
    const StepRule rule(scene, courant);
    step = std::min(step, rule.stable_step(material.density, modulus, rate, fast));
  }
  return step;
}

double growth_of(const Scene& scene, const std::string& verb) {
  for (const UpdateCost& cost : update_costs)
    if (verb == cost.verb) return cost.running / cost.elastic;
  if (verb == "update_deformation" && scene.grid.mode == Mode::three_dimensional)
    return growth_of_rotations;
  for (const char* reaching : {"project_particles", "interpolate_motion", "update_deformation"})
    if (verb == reaching && follows_deformation(scene)) return growth_of_domains;
  return 1.0;
}

Prediction predict_cost(const Scene& scene, const Probe& probe, int ranks) {
  Prediction prediction;
  prediction.first_step = stable_step_of_scene(scene, false);
  double dt = stable_step_of_scene(scene, true);
  if (probe.dt > 0.0) dt = std::min(dt, probe.dt);
  if (scene.step.largest_step > 0.0) dt = std::min(dt, scene.step.largest_step);
  prediction.steps = scene.end_time / dt;
  for (const BodySpec& body : scene.bodies)
    if (!is_rigid(scene, body))
      prediction.particle_steps +=
          static_cast<double>(count_body_particles(scene.grid, body)) * scene.end_time / dt;
  if (scene.jet.present)
    for (const JetSlug& slug : scene.jet.slugs)
      prediction.particle_steps += static_cast<double>(count_slug_particles(scene, slug)) *
                                   std::max(0.0, scene.end_time - slug.time) / dt;
  double grown = 1.0;
  for (const auto& [verb, share] : probe.shares) grown += share * (growth_of(scene, verb) - 1.0);
  if (probe.particles > 0.0) prediction.nanoseconds = 1e9 * probe.seconds / probe.particles * grown;
  prediction.seconds = 1e-9 * prediction.nanoseconds * prediction.particle_steps / ranks;
  // Every rank holds the program and its libraries, which are loaded by now.
  prediction.bytes = memory_estimate(scene) + ranks * peak_resident_bytes();
  return prediction;
}

}  // namespace barreno
