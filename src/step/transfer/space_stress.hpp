// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/kinematics.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Cauchy stress of a row in the space frame, R sigma R^T; without its artificial viscosity.
template <class M>
KOKKOS_INLINE_FUNCTION Sym3 space_stress(const Particles& particles, int p) {
  Sym3 unrotated{
      particles.stress(p, 0),
      particles.stress(p, 1),
      particles.stress(p, 2),
      particles.stress(p, 3),
      0.0,
      0.0};
  if constexpr (M::dimensions == 3) {
    unrotated.yz = particles.stress(p, 4);
    unrotated.zx = particles.stress(p, 5);
  }
  return rotate(
      load_rotation<M>(particles.deformation_gradient.values, particles.rotation.values, p),
      unrotated
  );
}

}  // namespace barreno
