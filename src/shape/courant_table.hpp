// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

namespace barreno {

/// Critical Courant numbers c dt / h of a free bar at 1, 2, 3, 4, 8 and 16 particles per cell: two
/// over the highest frequency of the lumped operator, the smallest over all places of the particles
/// in their cells. tests/unit/shape/test_critical_courant.cpp measures them from the weights and
/// prints the row of a shape function whose numbers are others.
struct CourantTable {
  double limit[6];

  /// Linear in the half size; in proportion to it below the last entry.
  KOKKOS_INLINE_FUNCTION constexpr double at(double half_size_in_cells) const {
    constexpr double half[6] = {0.5, 0.25, 1.0 / 6.0, 0.125, 0.0625, 0.03125};
    if (half_size_in_cells >= half[0]) return limit[0];
    for (int i = 1; i < 6; ++i)
      if (half_size_in_cells >= half[i])
        return limit[i] +
               (limit[i - 1] - limit[i]) * (half_size_in_cells - half[i]) / (half[i - 1] - half[i]);
    return limit[5] * half_size_in_cells / half[5];
  }
};

}  // namespace barreno
