// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/axis_weights.hpp"
#include "shape/particle_geometry.hpp"
#include "shape/tensor_support.hpp"

namespace barreno {

/// A shape function that is a product of one function of N nodes along each axis. S gives
///
///   axis_weights<Radial>(particle, d)   of the particle along axis d
///   face_weights(particle, d, side)     of its lower (-1) or upper (+1) face along that face's
///   normal
template <class S, unsigned N>
struct TensorShape {
  template <class M>
  using Support = TensorSupport<M::dimensions, N>;

  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> support(const ParticleGeometry& particle) {
    AxisWeights<N> w[extent<M::dimensions>];
    w[0] = S::template axis_weights<M::hoop>(particle, 0);
    for (int d = 1; d < M::dimensions; ++d) w[d] = S::template axis_weights<false>(particle, d);
    return tensor_product(w, particle.row);
  }

  /// Weights of a pressure on one face of the particle (0: x_lower, 1: x_upper, 2: y_lower ...).
  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> face_support(
      const ParticleGeometry& particle, int face
  ) {
    AxisWeights<N> w[extent<M::dimensions>];
    w[0] = S::template axis_weights<M::hoop>(particle, 0);
    for (int d = 1; d < M::dimensions; ++d) w[d] = S::template axis_weights<false>(particle, d);
    w[face / 2] = S::face_weights(particle, face / 2, face % 2 == 0 ? -1.0 : 1.0);
    return tensor_product(w, particle.row);
  }
};

/// Linear hat functions at a point in N nodes from `first` on.
template <unsigned N>
KOKKOS_INLINE_FUNCTION AxisWeights<N> hats_at(double x, int first) {
  AxisWeights<N> out;
  out.first = first;
  for (int i = 0; i < out.n; ++i) {
    const double distance = std::fabs(x - first - i);
    out.s[i] = distance < 1.0 ? 1.0 - distance : 0.0;
  }
  return out;
}

/// The node at or below x, moved down where N nodes from it on would not fit into the patch.
template <unsigned N>
KOKKOS_INLINE_FUNCTION int first_of(const ParticleGeometry& particle, double x) {
  const double most = particle.last - static_cast<int>(N - 1);
  const double node = std::floor(x);
  const double clamped = node < most ? node : most;
  return static_cast<int>(clamped > 0.0 ? clamped : 0.0);  // not a number: 0
}

}  // namespace barreno
