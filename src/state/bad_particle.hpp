// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/particles.hpp"

namespace barreno {

/// What becomes of a particle that went bad: it is held as stress-free debris, or marked with why
/// it is to be removed.
KOKKOS_INLINE_FUNCTION void treat_bad_particle(
    const Particles& particles, int p, BadParticlePolicy policy, Fault fault
) {
  particles.viscous_pressure(p) = 0.0;
  if (policy == BadParticlePolicy::hold) {
    for (int c = 0; c < particles.stress.components; ++c) particles.stress(p, c) = 0.0;
    particles.body(p) |= debris_bit;
  } else {
    particles.fault(p) = fault;
  }
}

}  // namespace barreno
