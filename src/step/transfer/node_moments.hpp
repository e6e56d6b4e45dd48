// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "grid/patch.hpp"

namespace barreno {

/// First and second moments of a particle's weights S_Ip, in cells: x = sum S x_I, and
/// D = sum S (x_I - x) (x_I - x)^T. D is diagonal for products of functions along the axes, 1/4 and
/// 1/3 of a square cell for quadratic and cubic splines off the walls; it depends on where the
/// particle is for the others.
template <int D>
struct NodeMoments {
  double centre[extent<D>] = {};
  double second[extent<D>][extent<D>] = {};

  template <class Support>
  KOKKOS_INLINE_FUNCTION NodeMoments(const Patch& patch, const Support& support) {
    support.for_each_node(patch, [&](int slot, double s, const double*, double) {
      double at[extent<D>];
      position_of_slot(patch, slot, at);
      for (int d = 0; d < D; ++d) centre[d] += s * at[d];
    });
    support.for_each_node(patch, [&](int slot, double s, const double*, double) {
      double at[extent<D>];
      position_of_slot(patch, slot, at);
      for (int d = 0; d < D; ++d) at[d] -= centre[d];
      for (int d = 0; d < D; ++d)
        for (int e = 0; e < D; ++e) second[d][e] += s * at[d] * at[e];
    });
  }
};

/// Of a matrix of second moments, for D x = b. Directions without a spread (a point on a node,
/// linear functions) get x = 0: there b is 0 too.
template <int D>
struct InverseMoments {
  static constexpr double smallest = 1e-12;
  double factor[extent<D>][extent<D>] = {};  ///< D = L diag(d) L^T, L below the diagonal
  double inverse[extent<D>] = {};            ///< 1 / d

  KOKKOS_INLINE_FUNCTION explicit InverseMoments(const double (&a)[extent<D>][extent<D>]) {
    double pivot[extent<D>] = {};
    for (int j = 0; j < D; ++j) {
      pivot[j] = a[j][j];
      for (int k = 0; k < j; ++k) pivot[j] -= factor[j][k] * factor[j][k] * pivot[k];
      inverse[j] = pivot[j] > smallest ? 1.0 / pivot[j] : 0.0;
      for (int i = j + 1; i < D; ++i) {
        double left = a[i][j];
        for (int k = 0; k < j; ++k) left -= factor[i][k] * factor[j][k] * pivot[k];
        factor[i][j] = left * inverse[j];
      }
    }
  }

  KOKKOS_INLINE_FUNCTION void solve(const double (&b)[extent<D>], double (&x)[extent<D>]) const {
    for (int i = 0; i < D; ++i) {
      x[i] = b[i];
      for (int k = 0; k < i; ++k) x[i] -= factor[i][k] * x[k];
    }
    for (int i = 0; i < D; ++i) x[i] *= inverse[i];
    for (int i = D - 1; i >= 0; --i)
      for (int k = i + 1; k < D; ++k) x[i] -= factor[k][i] * x[k];
  }
};

}  // namespace barreno
