// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/particles.hpp"

#include <barreno/history_values.hpp>
#include <barreno/tensor.hpp>

namespace barreno {

/// Unrotated stress and history of one particle, as its model knows them.
template <class Model>
struct MaterialPoint {
  Sym3 stress;
  typename Model::History history;

  KOKKOS_INLINE_FUNCTION static MaterialPoint read(const Particles& particles, int p) {
    MaterialPoint point{};
    double* const s = reals_of<double>(point.stress);
    for (int c = 0; c < particles.stress.components; ++c) s[c] = particles.stress(p, c);
    double* const h = history_values<Model>(point.history);
    for (int c = 0; c < Model::history_count; ++c) h[c] = particles.history(p, c);
    return point;
  }
  KOKKOS_INLINE_FUNCTION void write(int p, const Particles& particles) const {
    const double* const s = reals_of<double>(stress);
    for (int c = 0; c < particles.stress.components; ++c) particles.stress(p, c) = s[c];
    const double* const h = history_values<Model>(history);
    for (int c = 0; c < Model::history_count; ++c) particles.history(p, c) = h[c];
  }
};

}  // namespace barreno
