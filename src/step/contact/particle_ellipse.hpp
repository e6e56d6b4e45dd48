// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/patch_frame.hpp"
#include "state/particles.hpp"

namespace barreno {

/// A particle as its neighbours across a surface see it, in cells: where it is in a tile's patch,
/// and the half axes F e_i of the ellipse in its deformed box.
template <unsigned D>
struct ParticleEllipse {
  static constexpr int dimensions = D;
  double x[D];
  double axis[D][D];  ///< [i]: half axis that lay along i

  KOKKOS_INLINE_FUNCTION ParticleEllipse(
      const ParticleGeometry& particle, const Particles& particles, int p
  ) {
    for (int d = 0; d < dimensions; ++d) x[d] = particle.x[d];
    for (int i = 0; i < dimensions; ++i)
      for (int d = 0; d < dimensions; ++d)
        axis[i][d] = particles.deformation_gradient(p, d * dimensions + i) *
                     particles.half_size(p, i) * particle.per_cell;
  }

  /// How far it reaches from its centre along each of the first `count` directions, [axis][k].
  template <std::size_t N>
  KOKKOS_INLINE_FUNCTION void reach(const double (&directions)[D][N], int count, double (&out)[N])
      const {
    for (int k = 0; k < count; ++k) {
      double squared = 0.0;
      for (int i = 0; i < dimensions; ++i) {
        double along = 0.0;
        for (int d = 0; d < dimensions; ++d) along += axis[i][d] * directions[d][k];
        squared += along * along;
      }
      out[k] = std::sqrt(squared);
    }
  }
};

}  // namespace barreno
