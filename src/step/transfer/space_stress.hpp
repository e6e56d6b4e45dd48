// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/kinematics.hpp"

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

}  // namespace barreno
