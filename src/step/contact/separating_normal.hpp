// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/contact_nodes.hpp"

#include <Kokkos_Core.hpp>

#include <cmath>

namespace barreno {

/// Mean and scatter of a cloud.
template <unsigned D>
struct Cloud {
  static constexpr int dimensions = D;
  double mean[D], scatter[D][D];

  /// @param moments  moment_components(D) of them, positive weight
  KOKKOS_INLINE_FUNCTION explicit Cloud(const double* moments) {
    const double inverse = 1.0 / moments[0];
    for (int d = 0; d < dimensions; ++d) mean[d] = moments[1 + d] * inverse;
    const double* second = moments + 1 + dimensions;
    for (int i = 0; i < dimensions; ++i)
      for (int j = i; j < dimensions; ++j)
        scatter[i][j] = scatter[j][i] = *second++ * inverse - mean[i] * mean[j];
  }
};

/// x with A x = b, A symmetric and positive definite: elimination.
template <unsigned D>
KOKKOS_INLINE_FUNCTION void solve_definite(double (&a)[D][D], double (&b)[D], double (&x)[D]) {
  constexpr int dimensions = D;
  for (int i = 0; i < dimensions; ++i)
    for (int j = i + 1; j < dimensions; ++j) {
      const double factor = a[j][i] / a[i][i];
      for (int k = i; k < dimensions; ++k) a[j][k] -= factor * a[i][k];
      b[j] -= factor * b[i];
    }
  for (int i = dimensions - 1; i >= 0; --i) {
    x[i] = b[i];
    for (int k = i + 1; k < dimensions; ++k) x[i] -= a[i][k] * x[k];
    x[i] /= a[i][i];
  }
}

/// The unit normal, from a to b, of the plane that best separates two clouds (fit_surface_normals);
/// zero where they have one mean.
///
/// At a plane of symmetry the whole clouds, images included, have their mean on the plane, and a
/// normal is in the plane or across it: the one along which they lie further apart for their
/// scatter.
template <unsigned D>
KOKKOS_INLINE_FUNCTION void separating_normal(
    const double* first, const double* second, const bool (&mirrored)[D], double* n
) {
  constexpr int dimensions = D;
  const Cloud<D> a(first), b(second);
  double scatter[D][D], apart[D], along[D];
  for (int i = 0; i < dimensions; ++i) {
    apart[i] = b.mean[i] - a.mean[i];
    for (int j = 0; j < dimensions; ++j) scatter[i][j] = a.scatter[i][j] + b.scatter[i][j];
  }
  int across = -1;  // axis of the symmetry plane that separates them best, if one does
  double most = 0.0;
  for (int d = 0; d < dimensions; ++d) {
    const double quality = apart[d] * apart[d] / scatter[d][d];
    if (quality > most) {
      most = quality;
      across = mirrored[d] ? d : -1;
    }
  }
  for (int d = 0; d < dimensions; ++d)
    if (across >= 0 ? d != across : mirrored[d]) {
      apart[d] = 0.0;
      for (int k = 0; k < dimensions; ++k)
        if (k != d) scatter[d][k] = scatter[k][d] = 0.0;
    }
  solve_definite<D>(scatter, apart, along);
  double squared = 0.0;
  for (int d = 0; d < dimensions; ++d) squared += along[d] * along[d];
  const double inverse = squared > 0.0 ? 1.0 / std::sqrt(squared) : 0.0;
  for (int d = 0; d < dimensions; ++d) n[d] = along[d] * inverse;
}

}  // namespace barreno
