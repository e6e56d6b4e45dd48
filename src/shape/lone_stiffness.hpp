// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/patch.hpp"
#include "shape/kinematics.hpp"

namespace barreno {

/// k = h^2 sum_I |g_I|^2 / S_I of a particle that shares its nodes with no other [-], g_I the
/// gradient of S_I and, in axisymmetry, T_I added to its radial part. A pressure q of the particle
/// that acts for dt changes its own tr D by k q dt / (rho h^2). It bounds what particles that share
/// nodes do to each other: the largest frequency of a sum of elements is at most the largest of one
/// element.
///
/// Source of the bound: T. Hughes, The Finite Element Method (2000), 9.2, theorem of Irons.
template <class M, class Support>
KOKKOS_INLINE_FUNCTION double lone_stiffness(
    const Support& support, const Patch& sizes, double cell_size
) {
  constexpr unsigned dimensions = M::dimensions;
  constexpr unsigned most = 1U << (2 * dimensions);  // nodes of a support
  int slot[most] = {};
  double weight[most] = {};
  double gradient[most][dimensions] = {};
  unsigned count = 0;
  support.for_each_node(sizes, [&](int node, double s, const double* g, double t) {
    unsigned i = 0;
    while (i < count && slot[i] != node) ++i;
    if (i == count) slot[count++] = node;
    weight[i] += s;
    for (unsigned d = 0; d < dimensions; ++d) gradient[i][d] += g[d];
    if constexpr (M::hoop) gradient[i][0] += t;
  });
  double sum = 0.0;
  for (unsigned i = 0; i < count; ++i) {
    double squared = 0.0;
    for (unsigned d = 0; d < dimensions; ++d) squared += gradient[i][d] * gradient[i][d];
    if (weight[i] > 0.0) sum += squared / weight[i];
  }
  return cell_size * cell_size * sum;
}

}  // namespace barreno
