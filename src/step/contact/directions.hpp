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
  static constexpr std::size_t all = directions_about(D);
  static_assert(count == 1 + turned + dimensions, "itself, turned ones and the axes");

  double along[turns], aside[turns];  ///< cosine and sine of the turns
  double across[2][turns];            ///< of the second turn, about the normal (3D)
  bool axes;
  int different;  ///< so many to compare, the first ones

  /// About one normal.
  struct About {
    double n[D];
    double side[2][3];  ///< unit vectors across it

    KOKKOS_INLINE_FUNCTION explicit About(const double* normal) {
      for (int d = 0; d < dimensions; ++d) n[d] = normal[d];
      find_sides(n, side);
    }
  };

  Directions(double spread, bool with_axes)
      : axes(with_axes), different(with_axes ? count : 1 + turned) {
    const int steps = D == 2 ? 4 : 2;
    const int sides = turned / steps;
    const double turn = 2.0 * std::acos(-1.0) / sides;
    for (int i = 0; i < turned; ++i) {
      const int ring = i / sides + 1;
      const double angle = spread * ring / steps;
      along[i] = std::cos(angle);
      aside[i] = std::sin(angle);
      across[0][i] = D == 2 ? 1.0 - 2.0 * (i % sides) : std::cos(turn * (i % sides));
      across[1][i] = D == 2 ? 0.0 : std::sin(turn * (i % sides));
    }
  }

  /// The k-th direction; the normal itself where there is none.
  KOKKOS_INLINE_FUNCTION void find(const About& about, int k, double (&out)[D]) const {
    const auto& n = about.n;
    for (int d = 0; d < dimensions; ++d) out[d] = n[d];
    if (k == 0) return;
    if (k > turned) {
      const int axis = k - turned - 1;
      if (!axes || std::fabs(n[axis]) < 0.5) return;
      for (int d = 0; d < dimensions; ++d) out[d] = 0.0;
      out[axis] = n[axis] > 0.0 ? 1.0 : -1.0;
      return;
    }
    for (int d = 0; d < dimensions; ++d)
      out[d] = along[k - 1] * n[d] + aside[k - 1] * (across[0][k - 1] * about.side[0][d] +
                                                     across[1][k - 1] * about.side[1][d]);
  }

  /// All that differ, [axis][k]; loops that the compiler turns into vectors.
  KOKKOS_INLINE_FUNCTION void find_all(const About& about, double (&out)[D][all]) const {
    for (int d = 0; d < dimensions; ++d) {
      out[d][0] = about.n[d];
      for (int i = 0; i < turned; ++i)
        out[d][i + 1] = along[i] * about.n[d] + aside[i] * (across[0][i] * about.side[0][d] +
                                                            across[1][i] * about.side[1][d]);
    }
    for (int k = turned + 1; k < different; ++k) {
      double one[D];
      find(about, k, one);
      for (int d = 0; d < dimensions; ++d) out[d][k] = one[d];
    }
  }

  KOKKOS_INLINE_FUNCTION static void find_sides(const double (&n)[D], double (&side)[2][3]) {
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
