// SPDX-License-Identifier: BSD-3-Clause
#include "step/tally_domains.hpp"

#include "base/region.hpp"
#include "shape/visit_kernels.hpp"
#include "state/bad_particle.hpp"
#include "state/shape_fields.hpp"
#include "state/step_rule.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

template <class M, class S>
struct TallyDomains {
  PatchFrame<M::dimensions> frame;
  Particles particles;
  BadParticlePolicy policy;
  StepRule rule;

  void operator()(int p, DomainTally& tally) const {
    // What is asked depends on the radius at most, not on the tile.
    const typename PatchFrame<M::dimensions>::First anywhere{};
    const ParticlePlace place = frame.template place<S>(anywhere, shape_fields(particles), p);
    const bool clipped = S::template clipped<M>(place);
    particles.clipped(p) = clipped ? 1.0 : 0.0;
    tally.clipped += clipped ? 1.0 : 0.0;
    limit_step(p, S::critical_courant(S::template narrowest<M>(place)), tally);
    const bool treated = particles.key(p) <= failed_key || (particles.body(p) & held_bit) != 0;
    if (treated || !S::template inverted<M>(place)) return;
    tally.inverted += 1.0;
    const ParticleId id = particles.id(p);
    if (tally.first_bad < 0 || id < tally.first_bad) tally.first_bad = id;
    treat_bad_particle(particles, p, policy, inverted_key);
  }

  void limit_step(int p, double critical_courant, DomainTally& tally) const {
    if (!(critical_courant < particles.critical_courant)) return;
    const double density = particles.mass(p) / particles.volume(p);
    const Vector v = vector_of(particles.velocity, p);
    const double step = rule.stable_step(
        density,
        particles.longitudinal_modulus(p),
        rule.compression(density, particles.viscous_pressure(p)),
        std::hypot(v[0], v[1], v[2])
    );
    tally.stable_step =
        std::min(tally.stable_step, step * critical_courant / particles.critical_courant);
  }
};

}  // namespace

DomainTally tally_domains(const Scene& scene, const Grid& grid, Particles& particles) {
  DomainTally tally;
  if (particles.clipped.components == 0) return tally;
  const Region region("tally_domains");
  const MaterialSpec& material = scene.materials[static_cast<std::size_t>(particles.material)];
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    if constexpr (S::follows_deformation) {
      const TallyDomains<M, S> kernel{
          PatchFrame<M::dimensions>(scene, grid),
          particles,
          material.bad_particles,
          StepRule(scene, particles.critical_courant)};
      for (int p = 0; p < particles.count; ++p) kernel(p, tally);
    }
  });
  return tally;
}

}  // namespace barreno
