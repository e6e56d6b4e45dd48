// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "state/particles.hpp"

namespace barreno {

/// R sigma R^T of row p of columns with unrotated stress, F and R (load_rotation).
template <class M, class Stress, class Deformation, class Rotation>
KOKKOS_FORCEINLINE_FUNCTION Sym3 rotated_stress(
    const Stress& stress, const Deformation& deformation, const Rotation& rotation, int p
) {
  Sym3 unrotated{stress(p, 0), stress(p, 1), stress(p, 2), stress(p, 3), 0.0, 0.0};
  if constexpr (M::dimensions == 3) {
    unrotated.yz = stress(p, 4);
    unrotated.zx = stress(p, 5);
  }
  return rotate(load_rotation<M>(deformation, rotation, p), unrotated);
}

/// What the internal forces of the particles of a batch are found from.
template <class M>
struct StressColumns {
  static constexpr bool space = M::dimensions == 3;
  static constexpr unsigned in_plane = M::hoop ? 5 : 4;  ///< components of F
  BatchColumns<space ? 6 : 4> stress;
  BatchColumns<space ? 0 : in_plane> deformation;  ///< of which the rotation in the plane follows
  BatchColumns<space ? 4 : 0> rotation;
  BatchColumns<1> viscous_pressure, volume, mass;

  KOKKOS_INLINE_FUNCTION StressColumns(const Particles& particles, const BatchRows& rows) {
    stress.load(particles.stress, rows);
    deformation.load(particles.deformation_gradient, rows);
    rotation.load(particles.rotation, rows);
    viscous_pressure.load(particles.viscous_pressure, rows);
    volume.load(particles.volume, rows);
    mass.load(particles.mass, rows);
  }
  /// Cauchy stress of the k-th row in the space frame; without its artificial viscosity.
  KOKKOS_FORCEINLINE_FUNCTION Sym3 space_stress(int k) const {
    return rotated_stress<M>(stress, deformation, rotation, k);
  }
};

}  // namespace barreno
