// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"

#include <limits>

namespace barreno {

/// Domains of one set after a step; only of shape functions that deform with their particles.
struct DomainTally {
  double clipped = 0.0;       ///< shortened to Largest Domain
  double inverted = 0.0;      ///< turned inside out or flat by F
  ParticleId first_bad = -1;  ///< smallest id among the inverted
  double stable_step =
      std::numeric_limits<double>::infinity();  ///< of those narrower than at the start [time]
};

KOKKOS_INLINE_FUNCTION void add(const DomainTally& part, DomainTally& sum) {
  sum.clipped += part.clipped;
  sum.inverted += part.inverted;
  if (part.first_bad >= 0 && (sum.first_bad < 0 || part.first_bad < sum.first_bad))
    sum.first_bad = part.first_bad;
  sum.stable_step = part.stable_step < sum.stable_step ? part.stable_step : sum.stable_step;
}

/// Mark the particles whose domains are clipped (Particles::clipped) and give inverted ones to the
/// material's particle policy. A deformation gradient cannot be integrated through det F = 0, but
/// round-off of a needle may bring it there.
///
/// A domain that has become narrower allows a smaller step than the rest of its set, by its own
/// critical Courant number.
///
/// @param own_field  whether contact gives materials velocity fields of their own. A spray of
/// needles then has its nodes alone, and its viscosity limits the step.
DomainTally tally_domains(
    const StepSpec& step,
    BadParticlePolicy policy,
    bool own_field,
    const Grid& grid,
    Particles& particles
);

}  // namespace barreno
