// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <cmath>

namespace barreno {

/// Half edges of a particle's domain, a parallelogram (D = 2) or parallelepiped (3) around x_p:
/// e[i] is the vector from the centre to face i, F times the undeformed half edge.
template <int D>
struct Domain {
  double e[extent<D>][extent<D>]{};
};

/// e[0] x e[1], or e[0] . (e[1] x e[2]): area / 4 or volume / 8.
KOKKOS_FORCEINLINE_FUNCTION double measure(const Domain<2>& d) {
  return d.e[0][0] * d.e[1][1] - d.e[0][1] * d.e[1][0];
}
KOKKOS_FORCEINLINE_FUNCTION double measure(const Domain<3>& d) {
  const auto& e = d.e;
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/// Vectors from the centre to one corner of each pair of opposite corners:
/// e0 + e1, e0 - e1; in 3D e0 + e1 + e2, e0 - e1 + e2, -e0 + e1 + e2, -e0 - e1 + e2.
template <int D>
struct CornerVectors {
  static constexpr int n = 1 << (D - 1);
  double l[extent<n>][extent<D>]{};
};

template <int D>
KOKKOS_FORCEINLINE_FUNCTION CornerVectors<D> corner_vectors(const Domain<D>& domain) {
  CornerVectors<D> out;
  for (int k = 0; k < D; ++k) {
    if constexpr (D == 2) {
      out.l[0][k] = domain.e[0][k] + domain.e[1][k];
      out.l[1][k] = domain.e[0][k] - domain.e[1][k];
    } else {
      const double sum = domain.e[0][k] + domain.e[1][k];
      const double difference = domain.e[0][k] - domain.e[1][k];
      out.l[0][k] = domain.e[2][k] + sum;
      out.l[1][k] = domain.e[2][k] + difference;
      out.l[2][k] = domain.e[2][k] - difference;
      out.l[3][k] = domain.e[2][k] - sum;
    }
  }
  return out;
}

/// The domain with these corners: exact in 2D, least squares in 3D (four vectors, three edges).
template <int D>
KOKKOS_FORCEINLINE_FUNCTION Domain<D> rebuild_domain(const CornerVectors<D>& c) {
  Domain<D> out;
  for (int k = 0; k < D; ++k) {
    if constexpr (D == 2) {
      out.e[0][k] = 0.5 * (c.l[0][k] + c.l[1][k]);
      out.e[1][k] = 0.5 * (c.l[0][k] - c.l[1][k]);
    } else {
      out.e[0][k] = 0.25 * (c.l[0][k] + c.l[1][k] - c.l[2][k] - c.l[3][k]);
      out.e[1][k] = 0.25 * (c.l[0][k] - c.l[1][k] + c.l[2][k] - c.l[3][k]);
      out.e[2][k] = 0.25 * (c.l[0][k] + c.l[1][k] + c.l[2][k] + c.l[3][k]);
    }
  }
  return out;
}

template <std::size_t D>
KOKKOS_FORCEINLINE_FUNCTION double length_squared(const double (&v)[D]) {
  double sum = 0.0;
  for (std::size_t k = 0; k < D; ++k) sum += v[k] * v[k];
  return sum;
}

/// Whether some corner is further from the centre than `largest`. A corner that is not a number is.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION bool exceeds(const Domain<D>& domain, double largest) {
  const CornerVectors<D> c = corner_vectors(domain);
  bool out = false;
  for (int i = 0; i < CornerVectors<D>::n; ++i)
    out = out | !(length_squared(c.l[i]) <= largest * largest);
  return out;
}

/// Domain scaling: corner vectors longer than `largest` (l_crit) are shortened to it and the edges
/// rebuilt from them. Domains within the limit keep their bits. In 3D, where the corners after the
/// least squares differ from those before, one can be as far as 1.5 l_crit from the centre.
///
/// Source: M. Homel, R. Brannon, J. Guilkey, IJNME 107 (2016) 31-48.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION Domain<D> scale_domain(const Domain<D>& domain, double largest) {
  CornerVectors<D> c = corner_vectors(domain);
  bool shortened = false;
  for (int i = 0; i < CornerVectors<D>::n; ++i) {
    const double squared = length_squared(c.l[i]);
    const bool inside = squared <= largest * largest;
    const double ratio = inside ? 1.0 : largest / std::sqrt(squared);
    for (int k = 0; k < D; ++k) c.l[i][k] *= ratio;
    shortened = shortened | !inside;
  }
  Domain<D> rebuilt = rebuild_domain(c);
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k) rebuilt.e[i][k] = shortened ? rebuilt.e[i][k] : domain.e[i][k];
  return rebuilt;
}

/// Gradients of the domain's own coordinates, each of which runs from -1 to 1 between two faces:
/// grad xi_i . e_j = 1 if i = j, else 0. The domain's face i has the area vector
/// 2^(D-1) measure grad xi_i.
KOKKOS_FORCEINLINE_FUNCTION Domain<2> dual(const Domain<2>& d) {
  const double inverse = 1.0 / measure(d);
  return {
      {{d.e[1][1] * inverse, -d.e[1][0] * inverse}, {-d.e[0][1] * inverse, d.e[0][0] * inverse}}};
}
KOKKOS_FORCEINLINE_FUNCTION Domain<3> dual(const Domain<3>& d) {
  const double inverse = 1.0 / measure(d);
  Domain<3> out;
  for (int i = 0; i < 3; ++i) {
    const auto& a = d.e[(i + 1) % 3];
    const auto& b = d.e[(i + 2) % 3];
    for (int k = 0; k < 3; ++k)
      out.e[i][k] = (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) * inverse;
  }
  return out;
}

/// From the centre to face i: 1 / |grad xi_i|.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double half_width(const Domain<D>& dual, int i) {
  return 1.0 / std::sqrt(length_squared(dual.e[i]));
}

/// Faces that are nearer to the centre than `least` are moved out along their normals. A needle
/// that reaches into a cell by little gives next to no mass to the nodes there but the whole
/// gradient of its stress: without a least width there is no stable step. Domains that are wide
/// enough keep their bits.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION Domain<D> widen_domain(Domain<D> domain, double least) {
  for (int i = 0; i < D; ++i) {
    const Domain<D> slope = dual(domain);
    const double width = half_width(slope, i);
    // Along the normal, whose length is 1 / width.
    const double more = width < least ? (least - width) * width : 0.0;
    for (int d = 0; d < D; ++d)
      domain.e[i][d] = width < least ? domain.e[i][d] + more * slope.e[i][d] : domain.e[i][d];
  }
  return domain;
}

/// A domain that reaches across the axis is made narrower until it ends there: radial components
/// are shrunk by r_p / (|e0r| + |e1r|), axial ones are kept, so that it still touches the domains
/// above and below.
KOKKOS_FORCEINLINE_FUNCTION Domain<2> narrow_at_axis(Domain<2> domain, double radius) {
  const double reach = std::fabs(domain.e[0][0]) + std::fabs(domain.e[1][0]);
  const double ratio = reach <= radius ? 1.0 : radius / reach;
  domain.e[0][0] *= ratio;
  domain.e[1][0] *= ratio;
  return domain;
}

}  // namespace barreno
