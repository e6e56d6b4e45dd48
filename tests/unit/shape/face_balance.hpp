// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unit/shape/shape_cases.hpp"

namespace barreno::testing {

/// Edges of a particle's box [lengths]; F is diagonal.
template <class M, class S>
void box_edges(const ShapeCase& c, double (&edge)[3]) {
  for (int d = 0; d < 3; ++d)
    edge[d] = d < M::dimensions
                  ? 2.0 * c.particle.half[d] * cell * (S::follows_deformation ? c.stretch[d] : 1.0)
                  : 1.0;
}

/// Whether a particle has the faces of its volume: it is a box, not clipped, and neither the axis
/// nor an end of the grid cuts it.
template <class M, class S>
bool has_own_faces(const ShapeCase& c) {
  if (!c.straight) return false;
  if constexpr (S::follows_deformation)
    if (S::template clipped<M>(c.particle)) return false;
  double edge[3];
  box_edges<M, S>(c, edge);
  const ParticleGeometry& particle = c.particle;
  for (int d = 0; d < M::dimensions; ++d) {
    const double half = 0.5 * edge[d] / cell;
    if (particle.x[d] - half < particle.low[d] || particle.x[d] + half > particle.high[d])
      return false;
  }
  return true;
}

/// Whether the particle's box lies in one of the equal parts of a cell in which S integrates with
/// one point.
template <class M, class S>
bool in_balanced_part(const ShapeCase& c) {
  if (S::form != ParticleForm::point) return true;
  if (S::balanced_part <= 0.0) return false;
  for (int d = 0; d < M::dimensions; ++d) {
    const double lower = (c.particle.x[d] - c.particle.half[d]) / S::balanced_part;
    const double upper = (c.particle.x[d] + c.particle.half[d]) / S::balanced_part;
    if (std::floor(lower + 1e-9) + 1.0 < upper - 1e-9) return false;
  }
  return true;
}

/// Largest nodal force that V grad S (and V T) less the sum over the faces of n A S_face leaves, in
/// units of the particle's mean face. F is diagonal.
template <class M, class S>
double face_error(const ShapeCase& c) {
  constexpr int D = M::dimensions;
  const Patch patch = make_patch(D, reach);
  double edge[3];
  box_edges<M, S>(c, edge);
  const double radius = M::hoop ? position(c.particle, 0, c.particle.x[0]) : 1.0;
  const double volume = radius * edge[0] * edge[1] * edge[2];
  std::vector<double> force(static_cast<std::size_t>(3 * patch.size), 0.0);
  S::template support<M>(c.particle)
      .for_each_node(patch, [&](int slot, double, const double(&g)[extent<D>], double t) {
        const std::size_t i = 3 * static_cast<std::size_t>(slot);
        for (int d = 0; d < D; ++d) force[i + static_cast<std::size_t>(d)] += volume * g[d];
        if (M::hoop) force[i] += volume * t;
      });
  for (int face = 0; face < 2 * D; ++face) {
    const int d = face / 2;
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    double area = volume / edge[d];
    if (M::hoop && d == 0) area *= 1.0 + side * 0.5 * edge[0] / radius;
    S::template face_support<M>(c.particle, face)
        .for_each_node(patch, [&](int slot, double s, const auto&, double) {
          force[3 * static_cast<std::size_t>(slot) + static_cast<std::size_t>(d)] -=
              side * area * s;
        });
  }
  double largest = 0.0;
  for (const double f : force) largest = std::max(largest, std::abs(f));
  return largest * std::max(edge[0], edge[1]) / volume;
}

}  // namespace barreno::testing
