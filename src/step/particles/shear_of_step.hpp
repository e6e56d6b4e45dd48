// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/field.hpp"

#include <Kokkos_Core.hpp>

#include <cmath>

namespace barreno {

/// dt L_ij of a row; the hoop strain of two dimensions is entry 4.
template <class M>
KOKKOS_INLINE_FUNCTION double& increment_entry(const FieldView& increment, int p, int i, int j) {
  return increment(p, M::dimensions * i + j);
}

/// Norm of the deviator of dt D, the symmetric part of dt L [-].
/// @tparam M  mode
template <class M>
KOKKOS_INLINE_FUNCTION double shear_of_step(const FieldView& increment, int p) {
  const double hoop = M::dimensions == 2 ? increment(p, 4) : 0.0;
  double trace = hoop, squares = hoop * hoop;
  for (int i = 0; i < M::dimensions; ++i) {
    const double own = increment_entry<M>(increment, p, i, i);
    trace += own;
    squares += own * own;
    for (int j = 0; j < i; ++j) {
      const double twice =
          increment_entry<M>(increment, p, i, j) + increment_entry<M>(increment, p, j, i);
      squares += 0.5 * twice * twice;
    }
  }
  const double of_deviator = squares - trace * trace / 3.0;
  return of_deviator > 0.0 ? std::sqrt(of_deviator) : 0.0;
}

}  // namespace barreno
