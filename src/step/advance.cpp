// SPDX-License-Identifier: BSD-3-Clause
#include "step/advance.hpp"

#include "base/gather.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"
#include "step/balance_load.hpp"
#include "step/fit_normals.hpp"
#include "step/interpolate_motion.hpp"
#include "step/launch_jet.hpp"
#include "step/mirror_walls.hpp"
#include "step/move_particles.hpp"
#include "step/move_rigid.hpp"
#include "step/place_particles.hpp"
#include "step/project_body_force.hpp"
#include "step/project_loads.hpp"
#include "step/project_particles.hpp"
#include "step/release_torn_faces.hpp"
#include "step/seek_normals.hpp"
#include "step/share_nodes.hpp"
#include "step/solve_contact.hpp"
#include "step/solve_velocity.hpp"
#include "step/stable_step.hpp"
#include "step/surface_pressures.hpp"
#include "step/tally_domains.hpp"
#include "step/update_deformation.hpp"
#include "step/update_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace barreno {
namespace {

/// A step is taken again at most this often; then the particle policy acts.
constexpr int most_retries = 3;

void project_sets(const Scene& scene, State& state) {
  const Stopwatch watch;
  for (Nodes& nodes : state.nodes) clear_nodes(state.grid, nodes);
  for (const Particles& particles : state.particles)
    project_particles(
        scene, state.grid, particles, state.nodes[static_cast<std::size_t>(particles.field)]
    );
  state.effort.node_seconds += watch.seconds();
}

void add(const GridTally& part, GridTally& sum) {
  sum.kinetic_before += part.kinetic_before;
  sum.kinetic_after += part.kinetic_after;
  sum.force_work += part.force_work;
  sum.condition_work += part.condition_work;
  sum.condition_impulse += part.condition_impulse;
  sum.filter_impulse += part.filter_impulse;
  sum.damped += part.damped;
  sum.damping_impulse += part.damping_impulse;
  sum.absorbed += part.absorbed;
  sum.absorbed_impulse += part.absorbed_impulse;
  sum.contact_work += part.contact_work;
  sum.tangential_work += part.tangential_work;
}

/// Velocities of all fields that forces move, and what they do to each other.
GridTally solve_fields(
    const Scene& scene,
    double dt,
    const std::vector<MirroredSums>& mirrored,
    State& state,
    RigidTally& rigid
) {
  rigid = solve_contact(scene, dt, state);
  GridTally tally;
  for (std::size_t f = 0; f < state.nodes.size(); ++f) {
    if (state.fields.rigid_body[f] >= 0) continue;
    Nodes& nodes = state.nodes[f];
    GridTally part = solve_velocity(scene, state.grid, state.clock, dt, state.contact, nodes);
    unfold_walls(scene, state.grid, mirrored[f], dt, nodes, part);
    add(part, tally);
  }
  return tally;
}

/// Grid velocity and what it does to the particles, with a smaller step if a strain increment is
/// too large.
GridTally find_motion(
    const Scene& scene,
    const std::vector<MirroredSums>& mirrored,
    State& state,
    double& dt,
    RigidTally& rigid
) {
  GridTally tally;
  for (int retry = 0;; ++retry) {
    tally = solve_fields(scene, dt, mirrored, state, rigid);
    std::vector<double> strain{0.0};
    const Stopwatch watch;
    for (Particles& particles : state.particles) {
      if (particles.rigid) continue;
      const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
      strain[0] = std::max(strain[0], interpolate_motion(scene, state.grid, nodes, dt, particles));
    }
    state.effort.node_seconds += watch.seconds();
    max_over_ranks(*state.grid.comm, strain);
    if (!(strain[0] > scene.step.largest_strain) || retry == most_retries) return tally;
    dt *= std::max(0.25, 0.8 * scene.step.largest_strain / strain[0]);
    state.ledger.retried_steps += 1.0;
  }
}

void add(const ParticleTally& part, ParticleTally& sum) {
  sum.kinetic_before += part.kinetic_before;
  sum.kinetic_after += part.kinetic_after;
  sum.mass += part.mass;
  sum.momentum += part.momentum;
}

/// Particles with an inverted domain have failed like those that their material gave up.
void add(const DomainTally& domains, StressTally& set, double& clipped) {
  clipped += domains.clipped;
  StressTally failed;
  failed.failures = domains.inverted;
  failed.first_failed = domains.first_bad;
  add(failed, set);
}

/// Everything of the step that changes particles; returns what their materials said.
StressTally update_particles(
    const Scene& scene, double dt, State& state, ParticleTally& moved, StepResult& result
) {
  StressTally total;
  double clipped = 0.0;
  for (std::size_t s = 0; s < state.particles.size(); ++s) {
    Particles& particles = state.particles[s];
    StressTally set;
    if (particles.rigid) {
      set.stable_step = move_rigid(scene, state.clock, dt, particles);
      add(set, total);
      continue;
    }
    std::size_t block = 0;
    for_each_block(particles.count, [&](Rows rows) {
      const Stopwatch watch;
      add(move_particles(scene, dt, rows, particles), moved);
      update_deformation(scene, rows, particles);
      add(update_stress(scene, dt, rows, particles), set);
      state.effort.add(s, block++, watch.seconds());
    });
    add(tally_domains(scene, state.grid, particles), set, clipped);
    const BadParticlePolicy policy =
        scene.materials[static_cast<std::size_t>(particles.material)].bad_particles;
    if (policy == BadParticlePolicy::hold) state.ledger.held += set.failures;
    const bool stops = policy == BadParticlePolicy::stop;
    if (set.failures > 0.0 && stops && (result.failed < 0 || set.first_failed < result.failed))
      result = {true, set.first_failed, particles.material, result.interrupt};
    add(set, total);
    state.particle_steps += particles.count;
  }
  state.ledger.clipped = clipped;
  return total;
}

/// Each term where it arises; see Ledger.
void tally_step(
    const Scene& scene,
    const GridTally& grid,
    const RigidTally& rigid,
    double applied_work,
    const ParticleTally& moved,
    const StressTally& stress,
    State& state
) {
  Ledger& ledger = state.ledger;
  ledger.mass = moved.mass;
  ledger.momentum = moved.momentum;
  ledger.kinetic = moved.kinetic_after;
  ledger.boundary_work += grid.condition_work + grid.absorbed;
  ledger.load_impulse += grid.absorbed_impulse;
  ledger.damped += grid.damped;
  ledger.damping_impulse += grid.damping_impulse;
  ledger.condition_impulse +=
      grid.condition_impulse + scene.step.pic_fraction * grid.filter_impulse;
  ledger.transfer +=
      grid.kinetic_before - moved.kinetic_before + moved.kinetic_after - grid.kinetic_after;
  ledger.boundary_work += rigid.work;
  ledger.rigid_impulse += rigid.impulse + scene.step.pic_fraction * rigid.filter_impulse;
  const double lost_along = rigid.tangential_work - grid.tangential_work;
  ledger.friction += lost_along;
  ledger.transfer -= rigid.work - grid.contact_work - lost_along;
  ledger.elastic += stress.elastic;
  ledger.plastic += stress.plastic;
  ledger.viscous += stress.viscous;
  ledger.stress_integration +=
      grid.force_work + grid.damped - grid.absorbed - applied_work + stress.stress_work;
}

/// The verdict of all ranks; only scenes in which a failure stops the run pay for it.
void agree_on_failure(const Scene& scene, const State& state, StepResult& result) {
  const bool may_stop =
      std::any_of(scene.materials.begin(), scene.materials.end(), [](const MaterialSpec& m) {
        return m.bad_particles == BadParticlePolicy::stop;
      });
  if (!may_stop) return;
  constexpr double none = std::numeric_limits<double>::max();
  std::vector<double> first{result.failed < 0 ? none : static_cast<double>(result.failed)};
  min_over_ranks(*state.grid.comm, first);
  if (first[0] == none) return;
  std::vector<double> material{
      static_cast<double>(result.failed) == first[0] ? result.material : -1.0};
  max_over_ranks(*state.grid.comm, material);
  result = {
      true, static_cast<ParticleId>(first[0]), static_cast<int>(material[0]), result.interrupt};
}

}  // namespace

StepResult advance(const Scene& scene, double next_time, State& state) {
  const Region region("advance");
  auto& [grid, particles, fields, nodes, contact, clock, ledger, cavities, next_slug, slug_ids, stable, particle_steps, effort] =
      state;

  balance_load(scene, state);                            // tiles to ranks by measured cost
  launch_jet(scene, state);                              // slugs whose time has come
  Placement placement = locate_particles(scene, state);  // cell of each; the lost are tallied
  double dt = agree_on_step(scene, next_time, placement, state);  // the one reduction
  place_particles(scene, placement, state);                       // ranks, tiles, order

  project_sets(scene, state);        // m, p, f                           (2.1-2.3)
  release_torn_faces(scene, state);  // debris has none
  project_loads(scene, state);       // pressure on faces                 (2.4)
  project_surface_pressures(scene, state);
  project_body_force(scene, state);  // force per mass
  std::vector<MirroredSums> mirrored;
  for (Nodes& field : nodes) mirrored.push_back(fold_walls(scene, grid, field));  // symmetry planes
  for (const Nodes& field : nodes)
    exchange_halo(grid, field.sums, grid.patch.size * sum_components);
  share_nodes(state);          // where velocity fields meet: usually there is one  (6)
  fit_normals(scene, state);   // of the surfaces between them
  seek_normals(scene, state);  // turned to the widest gap, and the gap
  RigidTally rigid;
  const GridTally motion = find_motion(
      scene, mirrored, state, dt, rigid
  );  // v', conditions; v, dt L at particles (2.5-2.6)

  const double applied_work = tally_loads(scene, dt, state) +
                              tally_surface_pressures(scene, dt, state) +
                              tally_body_force(scene, dt, state);  // before F and x move on

  StepResult result;
  result.interrupt = placement.interrupt;
  ParticleTally moved;
  const StressTally stress =
      update_particles(scene, dt, state, moved, result);  // x, v, F, sigma (2.7-2.9)
  tally_step(
      scene, motion, rigid, applied_work, moved, stress, state
  );  // energy and momentum, term by term
  agree_on_failure(scene, state, result);

  stable = stress.stable_step;
  clock = {dt >= next_time - clock.time ? next_time : clock.time + dt, dt, clock.step + 1};
  return result;
}

}  // namespace barreno
