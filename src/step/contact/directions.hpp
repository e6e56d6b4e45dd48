// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/contact_nodes.hpp"

#include <Kokkos_Core.hpp>

#include <cmath>

namespace barreno {

/// Directions about a normal: itself, some turned away from it by up to a spread, and in the first
/// round the axes of the grid less than 60 degrees away.
template <unsigned D>
struct Directions {
  static constexpr int dimensions = D;
  static constexpr int turned = D == 2 ? 8 : 16;
  static constexpr std::size_t turns = D == 2 ? 8 : 16;
  static constexpr int count = directions_about(D);
  static_assert(count == 1 + turned + dimensions, "itself, turned ones and the axes");

  double along[turns], aside[turns];  ///< cosine and sine of the turns
  double across[turns][2];            ///< of the second turn, about the normal (3D)
  bool axes;

  Directions(double spread, bool with_axes) : axes(with_axes) {
    const int steps = D == 2 ? 4 : 2;
    const int sides = turned / steps;
    const double turn = 2.0 * std::acos(-1.0) / sides;
    for (int i = 0; i < turned; ++i) {
      const int ring = i / sides + 1;
      const double angle = spread * ring / steps;
      along[i] = std::cos(angle);
      aside[i] = std::sin(angle);
      across[i][0] = D == 2 ? 1.0 - 2.0 * (i % sides) : std::cos(turn * (i % sides));
      across[i][1] = D == 2 ? 0.0 : std::sin(turn * (i % sides));
    }
  }

  /// The k-th direction about n; n itself where there is none.
  KOKKOS_INLINE_FUNCTION void find(const double* n, int k, double (&out)[D]) const {
    for (int d = 0; d < dimensions; ++d) out[d] = n[d];
    if (k == 0) return;
    if (k > turned) {
      const int axis = k - turned - 1;
      if (!axes || std::fabs(n[axis]) < 0.5) return;
      for (int d = 0; d < dimensions; ++d) out[d] = 0.0;
      out[axis] = n[axis] > 0.0 ? 1.0 : -1.0;
      return;
    }
    double side[2][3];
    find_sides(n, side);
    for (int d = 0; d < dimensions; ++d)
      out[d] = along[k - 1] * n[d] +
               aside[k - 1] * (across[k - 1][0] * side[0][d] + across[k - 1][1] * side[1][d]);
  }

  /// Unit vectors across the normal.
  KOKKOS_INLINE_FUNCTION static void find_sides(const double* n, double (&side)[2][3]) {
    for (auto& vector : side) vector[0] = vector[1] = vector[2] = 0.0;
    if constexpr (D == 2) {
      side[0][0] = -n[1];
      side[0][1] = n[0];
    } else {
      const int least = std::fabs(n[0]) < 0.6 ? 0 : 1;  // an axis that is not the normal
      const double inverse = 1.0 / std::sqrt(1.0 - n[least] * n[least]);
      for (int d = 0; d < 3; ++d)
        side[0][d] = ((d == least ? 1.0 : 0.0) - n[least] * n[d]) * inverse;
      for (int d = 0; d < 3; ++d) {
        const int e = (d + 1) % 3;
        const int f = (d + 2) % 3;
        side[1][d] = n[e] * side[0][f] - n[f] * side[0][e];
      }
    }
  }
};

}  // namespace barreno
