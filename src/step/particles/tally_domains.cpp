// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/tally_domains.hpp"

#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "shape/lone_stiffness.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/bad_particle.hpp"
#include "state/row_frames.hpp"
#include "state/shape_fields.hpp"
#include "step/stable_step_rule.hpp"

#include <cmath>
#include <limits>

namespace barreno {
namespace {

/// A domain narrower than so much of its narrowest width at the start is a needle.
constexpr double needle_width = 0.5;

/// What the shape function says of the domains of some rows.
struct Domains {
  alignas(64) double clipped[rows_per_batch], inverted[rows_per_batch], narrowest[rows_per_batch];
};

template <class M, class S>
struct TallyDomains {
  PatchFrame<M::dimensions> frame;
  Particles particles;
  BadParticlePolicy policy;
  StableStepRule rule;
  RowFrames frames;
  double courant_fraction;
  bool own_field;  ///< contact gives the set nodes of its own

  KOKKOS_INLINE_FUNCTION void operator()(int batch, DomainTally& tally) const {
    const int begin = batch * rows_per_batch, left = particles.count - begin;
    const Rows rows{begin, begin + (left < rows_per_batch ? left : rows_per_batch)};
    Domains domains;
    find(rows, domains);
    for (int k = 0; k < rows.end - rows.begin; ++k) {
      const int p = rows.begin + k;
      particles.clipped(p) = domains.clipped[k];
      tally.clipped += domains.clipped[k];
      limit_step(p, S::critical_courant(domains.narrowest[k]), tally);
      // Boxes do not become needles: they follow the stretch along each axis, not the shear.
      if constexpr (S::form == ParticleForm::parallelogram)
        if (own_field && is_needle(p, domains.narrowest[k])) limit_step_of_needle(p, tally);
      if (domains.inverted[k] > 0.0) treat_inverted(p, tally);
    }
  }

  /// body(k, geometry) of the k-th row, without branches for the compiler to vectorise; of the last
  /// row again where there are fewer. What is asked depends on the radius at most, not on the tile.
  template <class Body>
  KOKKOS_INLINE_FUNCTION void for_each_geometry(Rows rows, const Body& body) const {
    const ShapeFields fields = shape_fields(particles);
    BARRENO_IVDEP
    for (int k = 0; k < rows_per_batch; ++k) {
      const int p = rows.begin + k < rows.end ? rows.begin + k : rows.end - 1;
      body(k, frame.template geometry<S>(frame.at_corner(frames.cell_size(p)), fields, p));
    }
  }

  /// One loop for each: together they are too much for the compiler.
  KOKKOS_INLINE_FUNCTION void find(Rows rows, Domains& out) const {
    for_each_geometry(rows, [&](int k, const ParticleGeometry& particle) {
      out.clipped[k] = S::template clipped<M>(particle) ? 1.0 : 0.0;
    });
    for_each_geometry(rows, [&](int k, const ParticleGeometry& particle) {
      out.inverted[k] = S::template inverted<M>(particle) ? 1.0 : 0.0;
    });
    for_each_geometry(rows, [&](int k, const ParticleGeometry& particle) {
      out.narrowest[k] = S::template narrowest<M>(particle);
    });
  }

  KOKKOS_INLINE_FUNCTION void treat_inverted(int p, DomainTally& tally) const {
    if (particles.fault(p) != Fault::none || (particles.body(p) & debris_bit) != 0) return;
    tally.inverted += 1.0;
    const ParticleId id = particles.id(p);
    if (tally.first_bad < 0 || id < tally.first_bad) tally.first_bad = id;
    treat_bad_particle(particles, p, policy, Fault::inverted);
  }

  KOKKOS_INLINE_FUNCTION void limit_step(int p, double critical_courant, DomainTally& tally) const {
    if (!(critical_courant < particles.critical_courant)) return;
    const double density = particles.mass(p) / particles.volume(p);
    const Vector v = vector_of(particles.velocity, p);
    const double h = frames.cell_size(p);
    const double step = rule.stable_step(
        h,
        density,
        particles.longitudinal_modulus(p),
        rule.compression(h, density, particles.viscous_pressure(p)),
        std::hypot(v[0], v[1], v[2])
    );
    const double of_domain = step * critical_courant / particles.critical_courant;
    tally.stable_step = of_domain < tally.stable_step ? of_domain : tally.stable_step;
  }

  /// @param narrowest  half width of its domain [cells]
  KOKKOS_INLINE_FUNCTION bool is_needle(int p, double narrowest) const {
    double least = frame.widest_half * frames.cell_size(p);
    for (int d = 0; d < M::dimensions; ++d)
      least = particles.half_size(p, d) < least ? particles.half_size(p, d) : least;
    return narrowest * frames.cell_size(p) < needle_width * least;
  }

  /// Support of row p where it is, in a patch that begins `reach` cells before it.
  KOKKOS_INLINE_FUNCTION auto support_of(int p) const {
    ParticleGeometry particle = frame.template geometry<S>(
        frame.at_corner(frames.cell_size(p)), shape_fields(particles), p
    );
    for (int d = 0; d < M::dimensions; ++d) {
      const double first = std::floor(particle.x[d]) - frame.patch.reach;
      particle.x[d] -= first;
      particle.low[d] -= first;
      particle.high[d] -= first;
      if (d == 0) particle.axis += first;
    }
    return S::template support<M>(particle);
  }

  /// The viscosity of a step acts in the next one. A needle alone in its nodes would be turned from
  /// compression to a faster expansion by it, and back, unless (docs/method.md 1, thin domains)
  ///
  ///   dt <= X h / (Q/X + sqrt((Q/X)^2 + c^2)),   X = 2 / sqrt(k),   q = rho Q h |tr D|
  KOKKOS_INLINE_FUNCTION void limit_step_of_needle(int p, DomainTally& tally) const {
    const double q = particles.viscous_pressure(p);
    if (!(q > 0.0)) return;
    const double h = frames.cell_size(p);
    const double density = particles.mass(p) / particles.volume(p);
    const double c = std::sqrt(particles.longitudinal_modulus(p) / density);
    const double half = 0.5 * rule.linear * c;
    const double viscous_speed = half + std::sqrt(half * half + rule.quadratic * q / density);
    const double critical = 2.0 / std::sqrt(lone_stiffness<M>(support_of(p), frame.patch, h));
    const double slowed = viscous_speed / critical;
    const double step = courant_fraction * critical * h / (slowed + std::hypot(slowed, c));
    tally.stable_step = step < tally.stable_step ? step : tally.stable_step;
  }
};

}  // namespace

DomainTally tally_domains(
    const StepSpec& step,
    BadParticlePolicy policy,
    bool own_field,
    const Grid& grid,
    Particles& particles
) {
  DomainTally tally;
  if (particles.clipped.components == 0) return tally;
  const Region region("tally_domains");
  visit_kernels(grid, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    if constexpr (S::follows_deformation) {
      const TallyDomains<M, S> kernel{
          PatchFrame<M::dimensions>(grid),
          particles,
          policy,
          StableStepRule(step, grid.mode, particles.critical_courant, particles.isolated_courant),
          RowFrames(grid, particles),
          step.courant_fraction,
          own_field};
      launch_reduction(
          "tally_domains",
          range((particles.count + rows_per_batch - 1) / rows_per_batch),
          kernel,
          TallyReducer<DomainTally>(tally)
      );
    }
  });
  return tally;
}

}  // namespace barreno
