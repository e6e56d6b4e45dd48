// SPDX-License-Identifier: BSD-3-Clause
#include "step/jet/launch_jet.hpp"

#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "state/build_state.hpp"

#include <algorithm>

namespace barreno {
namespace {

GridSpec box_of(const Grid& grid) {
  return {
      grid.mode,
      {grid.lower[0], grid.lower[1], grid.lower[2]},
      {grid.upper[0], grid.upper[1], grid.upper[2]},
      grid.cell_size,
      grid.host_level_of_tile};
}

/// Where the particles of a slug are now, as far as they are in tiles of this rank.
std::vector<NewParticle> cut_slug(
    const JetSpec& jet,
    const JetSlug& slug,
    double density,
    ParticleId first_id,
    const Grid& grid,
    double time
) {
  const double velocity = jet.direction * slug.velocity;
  const double centre = jet.launch_position + velocity * (time - slug.time);
  const int me = grid.comm->getRank();
  std::vector<NewParticle> made;
  for_each_slug_particle(box_of(grid), jet, density, slug, first_id, [&](NewParticle particle) {
    particle.x[1] += centre;
    particle.id = first_id + (particle.id - first_id) * ids_of_particle(jet);
    particle.velocity = {0.0, velocity, 0.0};
    if (grid.holds(particle.x) && owner_of(grid, particle.x) == me) made.push_back(particle);
  });
  return made;
}

/// A point of a slug before it moves: of a continuous jet with the voids of the slug's density.
StartPoint start_of(const JetSpec& jet, const JetSlug& slug, const MaterialSpec& material) {
  if (!traits_of(jet.kind).expanded) return start_point(material, nullptr);
  return expanded_start_point(material, std::max(1.0, material.density() / slug.density));
}

struct LaunchTally {
  ReproducibleSum mass, momentum, kinetic;
};
KOKKOS_INLINE_FUNCTION void add(const LaunchTally& from, LaunchTally& to) {
  to.mass += from.mass;
  to.momentum += from.momentum;
  to.kinetic += from.kinetic;
}

void tally_launched(const Particles& particles, int first_row, OwnLedger& ledger) {
  const FieldView mass = particles.mass.values, velocity = particles.velocity.values;
  LaunchTally tally;
  launch_reduction(
      "tally_launched",
      range({first_row, particles.count}),
      KOKKOS_LAMBDA(const int p, LaunchTally& part) {
        const double m = mass(p, 0), v = velocity(p, 1);
        part.mass += m;
        part.momentum += m * v;
        part.kinetic += 0.5 * m * v * v;
      },
      TallyReducer<LaunchTally>(tally)
  );
  ledger.launched_mass += tally.mass;
  ledger.launched_momentum += tally.momentum;
  ledger.launched_kinetic += tally.kinetic;
}

}  // namespace

int launch_jet(
    const JetSpec& jet,
    const MaterialSpec& material,
    const Grid& grid,
    double time,
    JetState& launched,
    Particles& particles,
    OwnLedger& ledger
) {
  const int first_row = particles.count;
  std::size_t& next_slug = launched.next_slug;
  if (next_slug == jet.slugs.size()) return first_row;
  const Region region("launch_jet");
  if (jet.slugs[next_slug].time > time) return first_row;
  for (; next_slug < jet.slugs.size() && jet.slugs[next_slug].time <= time; ++next_slug) {
    const ParticleId first_id = launched.slug_ids[next_slug];
    const JetSlug& slug = jet.slugs[next_slug];
    const std::vector<NewParticle> made =
        cut_slug(jet, slug, material.density(), first_id, grid, time);
    add_particles(material, made, launched.body, start_of(jet, slug, material), particles);
  }
  tally_launched(particles, first_row, ledger);
  return first_row;
}

}  // namespace barreno
