// SPDX-License-Identifier: BSD-3-Clause
#include "step/tally_domains.hpp"

#include "base/region.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/bad_particle.hpp"

namespace barreno {
namespace {

template <class M, class S>
struct TallyDomains {
  PatchFrame<M::dimensions> frame;
  Particles particles;
  BadParticlePolicy policy;

  void operator()(int p, DomainTally& tally) const {
    // Neither question depends on where the particle is.
    const typename PatchFrame<M::dimensions>::First anywhere{};
    const ParticlePlace place = frame.template place<S>(anywhere, shape_fields(particles), p);
    const bool clipped = S::template clipped<M>(place);
    particles.clipped(p) = clipped ? 1.0 : 0.0;
    tally.clipped += clipped ? 1.0 : 0.0;
    const bool treated = particles.key(p) <= failed_key || (particles.body(p) & held_bit) != 0;
    if (treated || !S::template inverted<M>(place)) return;
    tally.inverted += 1.0;
    const ParticleId id = particles.id(p);
    if (tally.first_bad < 0 || id < tally.first_bad) tally.first_bad = id;
    treat_bad_particle(particles, p, policy, inverted_key);
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
          PatchFrame<M::dimensions>(scene, grid), particles, material.bad_particles};
      for (int p = 0; p < particles.count; ++p) kernel(p, tally);
    }
  });
  return tally;
}

}  // namespace barreno
