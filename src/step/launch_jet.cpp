// SPDX-License-Identifier: BSD-3-Clause
#include "step/launch_jet.hpp"

#include "base/region.hpp"
#include "state/build_state.hpp"
#include "step/stable_step.hpp"

#include <algorithm>

namespace barreno {
namespace {

void launch_slug(const Scene& scene, std::size_t index, State& state) {
  const JetSlug& slug = scene.jet.slugs[index];
  Particles& particles = state.particles[static_cast<std::size_t>(scene.jet.material)];
  const double centre = scene.jet.launch_position +
                        scene.jet.direction * slug.velocity * (state.clock.time - slug.time);
  const Vector velocity{0.0, scene.jet.direction * slug.velocity, 0.0};
  const auto body = static_cast<int>(scene.bodies.size());
  const StartPoint start = start_point(scene, scene.jet.material, nullptr);
  for_each_slug_particle(scene, slug, state.slug_ids[index], [&](NewParticle made) {
    made.x[1] += centre;
    if (!state.grid.holds(made.x) || owner_of(state.grid, made.x) != state.grid.comm->getRank())
      return;
    const int p = add_particle(scene, particles, made, body, start, velocity);
    const double m = particles.mass(p);
    state.ledger.launched_mass += m;
    state.ledger.launched_momentum += m * velocity[1];
    state.ledger.launched_kinetic += 0.5 * m * velocity[1] * velocity[1];
  });
}

}  // namespace

void launch_jet(const Scene& scene, State& state) {
  if (!scene.jet.present) return;
  const Region region("launch_jet");
  Particles& particles = state.particles[static_cast<std::size_t>(scene.jet.material)];
  const int first_row = particles.count;
  for (; state.next_slug < scene.jet.slugs.size(); ++state.next_slug) {
    if (scene.jet.slugs[state.next_slug].time > state.clock.time) break;
    launch_slug(scene, state.next_slug, state);
  }
  state.stable_step = std::min(state.stable_step, stable_step_of_rows(scene, particles, first_row));
}

}  // namespace barreno
