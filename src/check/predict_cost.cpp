// SPDX-License-Identifier: BSD-3-Clause
#include "check/predict_cost.hpp"

#include "base/process.hpp"
#include "check/body_steps.hpp"
#include "check/update_row.hpp"
#include "jet/estimate.hpp"
#include "scene/build_scene.hpp"
#include "scene/geometry.hpp"
#include "scene/lighting.hpp"
#include "scene/tile_levels.hpp"
#include "shape/shape_facts.hpp"
#include "shape/visit_kernels.hpp"
#include "state/bodies/body_particles.hpp"
#include "state/isolated_courant.hpp"
#include "step/particles/update_stress.hpp"
#include "step/stable_step.hpp"
#include "step/stable_step_rule.hpp"

#include <algorithm>
#include <barreno/models.hpp>
#include <cmath>
#include <limits>
#include <variant>

namespace barreno {
namespace {

/// Compression of what collides, over the speed of its bodies: h |tr D| / v. Fits the steps of
/// shock_copper.xml, where the shocked metal is also stiffer.
constexpr double compression = 0.5;
/// The same for a jet, which flows more than it is compressed: perforation_plane_gimp.xml.
constexpr double compression_of_jet = 0.05;

/// Greatest |sin(k . x)| in a body, or what bounds it: a wave much longer than the body is the way
/// to write a linear field.
double wave_share(const Scene& scene, const BodySpec& body) {
  if (body.velocity_wave_number == Vector{}) return 1.0;
  const Box box = box_around(body.shape, scene.grid);
  double phase = 0.0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++d)
    phase += std::abs(body.velocity_wave_number[d]) *
             std::max(std::abs(box.lower[d]), std::abs(box.upper[d]));
  return std::min(1.0, phase);
}

double body_speed(const Scene& scene, int material) {
  double speed = 0.0;
  for (const BodySpec& body : scene.bodies)
    if (body.material == material)
      speed = std::max(
          speed, length_of(body.velocity) * wave_share(scene, body) + std::abs(body.radial_velocity)
      );
  return speed;
}

/// Of a jet that an explosive forms of this material: as fast as the detonation, which lies between
/// the tips of jet_formation.xml (8.5 km/s, single particles 11.7) and those of thicker cones.
/// Boxes are thrown whole: plates, tubes in axisymmetry.
double formed_jet_speed(const Scene& scene, int material) {
  const bool may_collapse =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodySpec& body) {
        return body.material == material && !is_explosive(scene, body) &&
               !std::holds_alternative<Box>(body.shape);
      });
  if (!may_collapse) return 0.0;
  double speed = 0.0;
  for (const BodySpec& body : scene.bodies)
    if (is_explosive(scene, body))
      speed = std::max(
          speed, *scene.materials[static_cast<std::size_t>(body.material)].detonation_speed()
      );
  return speed;
}

double jet_speed(const Scene& scene, int material) {
  double speed = formed_jet_speed(scene, material);
  if (scene.jet.present && scene.jet.material == material)
    for (const JetSlug& slug : scene.jet.slugs) speed = std::max(speed, slug.velocity);
  return speed;
}

/// Instants of an output; an interval of 0 means the given number.
double instants(const Scene& scene, double interval, double otherwise) {
  return interval > 0.0 ? scene.end_time / interval : otherwise;
}

/// @param particles  that the run has on average
double written_nanoseconds(
    const Scene& scene, const CostTables& tables, double particles, double steps
) {
  const double fields = instants(scene, scene.output.field_interval, 1.0) + 1.0;
  const double rows = instants(scene, scene.output.history_interval, steps);
  return particles * (tables.field_nanoseconds * fields + tables.row_nanoseconds * rows);
}

bool has_particles(const Scene& scene, int material) {
  const auto is_of = [&](const BodySpec& body) { return body.material == material; };
  return (scene.jet.present && scene.jet.material == material) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(), is_of);
}

}  // namespace

std::vector<double> stable_steps_of_materials(const Scene& scene, bool viscous) {
  std::vector<double> steps;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const int index = static_cast<int>(m);
    if (!has_particles(scene, index)) {
      steps.push_back(std::numeric_limits<double>::infinity());
      continue;
    }
    const Material& material = scene.materials[m].material();
    const double courant = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(smallest_half_size(scene, index));
    });
    const double modulus = std::visit(
        [](const auto& model) {
          return model.longitudinal_modulus({}, model.initial_history(), 1.0);
        },
        material.model
    );
    const double slow = body_speed(scene, index), jet = jet_speed(scene, index);
    const double jump = std::max(compression * slow, compression_of_jet * jet);
    // Any rate below zero brings the linear part; that of the colliding bodies the quadratic one.
    const double cell_size = smallest_cell(scene.grid);
    const double rate = viscous ? -(jump + 1e-9) / cell_size : 0.0;
    const StableStepRule rule(
        scene.step, scene.grid.mode, courant, isolated_courant(scene, static_cast<int>(m))
    );
    steps.push_back(
        rule.stable_step(cell_size, material.density, modulus, rate, std::max(slow, jet))
    );
  }
  return steps;
}

namespace {

/// Step of what burns, in the Chapman-Jouguet state, which a front of some cells reaches;
/// infinite where nothing does [time].
double step_of_front(const Scene& scene) {
  const double cell_size = smallest_cell(scene.grid);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m].material();
    const auto* const explosive = std::get_if<JwlExplosive>(&material.model);
    if (explosive == nullptr) continue;
    const int index = static_cast<int>(m);
    const double courant = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(smallest_half_size(scene, index));
    });
    const auto state = explosive->products().chapman_jouguet();
    const double flow = state.speed * (1.0 - state.volume_ratio);
    const double sound = state.speed * state.volume_ratio;
    const double density = material.density / state.volume_ratio;
    const double rate = -flow / (explosive->parameters().burn_width * cell_size);
    const StableStepRule rule(scene.step, scene.grid.mode, courant, isolated_courant(scene, index));
    const double modulus = density * sound * sound;
    least = std::min(least, rule.stable_step(cell_size, density, modulus, rate, flow));
  }
  return least;
}

/// When the last corner of an explosive is lit, as nothing were in the way [time].
double end_of_burning(const Scene& scene) {
  double last = 0.0;
  for (const BodySpec& body : scene.bodies) {
    if (!is_explosive(scene, body)) continue;
    const Box box = box_around(body.shape, scene.grid);
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vector x{};
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++d)
        x[d] = (corner >> d & 1U) != 0 ? box.upper[d] : box.lower[d];
      last = std::max(last, straight_lighting_time(scene.detonation, scene.grid.mode, x));
    }
  }
  return std::min(last, scene.end_time);
}

/// Steps of a run whose steps are of this length where no front passes.
double steps_of_run(const Scene& scene, double dt) {
  const double burning = end_of_burning(scene);
  return burning / std::min(dt, step_of_front(scene)) + (scene.end_time - burning) / dt;
}

}  // namespace

double stable_step_of_scene(const Scene& scene, bool viscous) {
  double least = std::numeric_limits<double>::infinity();
  for (const double step : stable_steps_of_materials(scene, viscous)) least = std::min(least, step);
  return damped_step(least, scene.step.damping, scene.step.courant_fraction);
}

double growth_of(const Scene& scene, const std::string& verb, const CostTables& tables) {
  if (!tables.problem.empty()) return 1.0;
  double update = 0.0;  // the most, where materials share a verb
  for (const MaterialSpec& material : scene.materials) {
    if (verb != stress_label(material.material())) continue;
    const std::optional<UpdateCost> cost = update_cost(material.material(), tables);
    if (cost) update = std::max(update, cost->running / cost->elastic);
  }
  if (update > 0.0) return update;
  if (verb == "update_deformation" && scene.grid.mode == Mode::three_dimensional)
    return tables.rotations;
  for (const char* reaching : {"project_particles", "interpolate_motion", "update_deformation"})
    if (verb == reaching && follows_deformation(scene)) return tables.domains;
  return 1.0;
}

std::string why_cost_unknown(const Scene& scene, const CostTables& tables) {
  if (!tables.problem.empty()) return tables.problem;
  for (const MaterialSpec& material : scene.materials)
    if (!update_cost(material.material(), tables))
      return "the measured numbers of update_costs.csv have no row \"" +
             update_row(material.material()) + "\"";
  return {};
}

namespace {

/// A step, or the part of one of several parts, as the jet and its target allow [time].
double part_of_step(const Scene& scene, const Probe& probe, const CostTables& tables) {
  double dt = stable_step_of_scene(scene, true);
  if (probe.dt > 0.0) dt = std::min(dt, probe.dt);
  if (scene.jet.present && scene.step.subcycles > 1) dt /= tables.parts_of_flight;
  if (scene.step.largest_step > 0.0) dt = std::min(dt, scene.step.largest_step);
  return scene.end_time / steps_of_run(scene, dt);
}

double steps_of_jet(const Scene& scene, const std::vector<long long>& counts, double dt) {
  double steps = 0.0;
  if (!scene.jet.present) return steps;
  const std::size_t bodies = scene.bodies.size();
  for (std::size_t s = 0; s < scene.jet.slugs.size(); ++s)
    steps += static_cast<double>(counts[bodies + s]) *
             std::max(0.0, scene.end_time - scene.jet.slugs[s].time) / dt;
  return steps;
}

bool works_on_nodes(const std::string& verb) {
  const auto verbs = {"solve_velocity", "locate_particles", "place_particles"};
  return std::find(verbs.begin(), verbs.end(), verb) != verbs.end();
}

/// Of a step of one awake particle, what works on nodes and what on itself.
struct StepCost {
  double nodes = 0.0, particle = 0.0;  ///< [ns]
};
StepCost step_cost(const Scene& scene, const Probe& probe, const CostTables& tables) {
  StepCost cost;
  if (!(probe.particles > 0.0)) return cost;
  const double whole = 1e9 * probe.seconds / probe.particles;
  if (probe.shares.empty()) cost.particle = whole;
  for (const auto& [verb, share] : probe.shares)
    (works_on_nodes(verb) ? cost.nodes : cost.particle) +=
        share * growth_of(scene, verb, tables) * whole;
  return cost;
}

}  // namespace

Prediction predict_cost(
    const Scene& scene,
    const Probe& probe,
    const std::vector<long long>& counts,
    int ranks,
    const CostTables& tables
) {
  if (scene.at_rest) {
    Scene expected = scene;
    expected.at_rest = false;
    expected.end_time = expected_end(scene);
    return predict_cost(expected, probe, counts, ranks, tables);
  }
  Prediction prediction;
  prediction.first_step = stable_step_of_scene(scene, false);
  // Every rank holds the program and its libraries; the probe was on this one alone.
  prediction.bytes =
      memory_estimate(scene) + peak_resident_bytes() + (ranks - 1) * probe.program_bytes;
  prediction.unknown = why_cost_unknown(scene, tables);
  if (!tables.problem.empty()) return prediction;  // steps of a jet in parts are measured too
  const double dt = part_of_step(scene, probe, tables);
  prediction.steps = scene.end_time / dt / scene.step.subcycles;
  const BodySteps bodies = steps_of_bodies(scene, counts, dt);
  const double of_jet = steps_of_jet(scene, counts, dt);
  prediction.particle_steps = bodies.taken + of_jet;
  prediction.shares = bodies.shares;
  if (!prediction.unknown.empty()) return prediction;
  const StepCost cost = step_cost(scene, probe, tables);
  // Nodes move in every part, and particles are looked for.
  const double parts = scene.step.subcycles > 1 ? tables.nodes_of_parts * (bodies.awake + of_jet)
                                                : prediction.particle_steps;
  const double computed = cost.particle * prediction.particle_steps + cost.nodes * parts;
  prediction.nanoseconds = computed / prediction.particle_steps;
  const double particles = (bodies.all + of_jet) * dt / scene.end_time;
  const double written = written_nanoseconds(scene, tables, particles, prediction.steps);
  prediction.seconds = 1e-9 * (computed + written) / ranks;
  return prediction;
}

}  // namespace barreno
