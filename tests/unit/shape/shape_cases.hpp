// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/visit_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace barreno::testing {

inline constexpr double cell = 0.37;
inline constexpr int reach =
    2;  ///< of the patch in these tests; the least that no shape function exceeds

/// A particle somewhere, with what the tests need to know of it beyond its particle.
struct ShapeCase {
  ParticleGeometry particle;
  double stretch[3] = {1.0, 1.0, 1.0};  ///< diagonal of U of its F
  bool straight = true;                 ///< F is diagonal
};

/// F = R(angle) U, U = diag(a, b) + shear; in three dimensions about z.
inline void deform(ShapeCase& c, double angle, double a, double b, double shear) {
  const double u[2][2] = {{a, shear}, {shear, b}};
  const double cosine = std::cos(angle), sine = std::sin(angle);
  for (int i = 0; i < 2; ++i) {
    c.particle.f[0][i] = cosine * u[0][i] - sine * u[1][i];
    c.particle.f[1][i] = sine * u[0][i] + cosine * u[1][i];
    c.stretch[i] = c.particle.stretch[i] = u[i][i];
  }
  c.straight = angle == 0.0 && shear == 0.0;
}

/// A particle at `x` cells from the corner of a grid of 8 cells per direction that begins `first`
/// cells from the axis, one of `per_cell`.
template <class M>
ShapeCase particle_at(const double (&x)[3], int per_cell, double first) {
  ShapeCase c;
  const Patch patch = make_patch(M::dimensions, reach);
  for (int d = 0; d < M::dimensions; ++d) {
    c.particle.x[d] = reach + x[d];
    c.particle.half[d] = 0.5 / per_cell;
    c.particle.low[d] = reach;
    c.particle.high[d] = reach + patch.tile_cells;
  }
  c.particle.axis = first - reach;
  c.particle.per_cell = 1.0 / cell;
  c.particle.row = patch.nodes;
  c.particle.last = patch.nodes - 1;
  c.particle.largest = 1.0;
  return c;
}

/// The particle of a case in a patch of another reach.
template <class M>
ParticleGeometry place_in_patch(const ShapeCase& c, int other_reach) {
  ParticleGeometry particle = c.particle;
  const Patch patch = make_patch(M::dimensions, other_reach);
  const double shift = other_reach - reach;
  for (int d = 0; d < M::dimensions; ++d) {
    particle.x[d] += shift;
    particle.low[d] += shift;
    particle.high[d] += shift;
  }
  particle.axis -= shift;
  particle.row = patch.nodes;
  particle.last = patch.nodes - 1;
  return particle;
}

/// Particles of 1 to 4 per cell everywhere in the cells, at both ends of the grid and at the axis;
/// for a shape function that follows F also turned, sheared, stretched, and stretched beyond
/// Largest Domain.
template <class M, class S>
std::vector<ShapeCase> shape_cases(double first) {
  const double end = make_patch(M::dimensions, reach).tile_cells;
  std::vector<ShapeCase> undeformed;
  for (const int per_cell : {1, 2, 3, 4}) {
    const double half = 0.5 / per_cell;
    for (int i = 0; i < 2 * per_cell; ++i)
      for (const double shift : {0.0, 0.13, 0.5, 0.77}) {
        const double x = half + 2.0 * half * i + shift;
        undeformed.push_back(particle_at<M>({x, 2.0 + shift, 1.9 - shift}, per_cell, first));
      }
    undeformed.push_back(particle_at<M>({half, end - half, half}, per_cell, first));
    undeformed.push_back(particle_at<M>({end - half, half, end - half}, per_cell, first));
    // Cut by the axis or the end of the grid, and barely inside it.
    for (const double r : {0.01, 0.1, 0.24})
      undeformed.push_back(particle_at<M>({r, end - r, r}, per_cell, first));
  }
  if (!S::follows_deformation) return undeformed;
  std::vector<ShapeCase> out = undeformed;
  for (const ShapeCase& c : undeformed)
    for (const double angle : {0.0, 0.4, -2.0})
      for (const double shear : {0.0, 0.3})
        for (const double size : {0.6, 1.3, 5.0}) {
          out.push_back(c);
          deform(out.back(), angle, size, 1.1, shear);
        }
  return out;
}

using NodeField = std::function<double(const double (&x)[3])>;

/// Means over a particle: value, gradient, and in axisymmetry int f dr dz / int r dr dz.
struct Means {
  double value = 0.0, gradient[3] = {}, hoop = 0.0;
};

/// Position of a particle, in lengths; the first coordinate is r in axisymmetry.
inline double position(const ParticleGeometry& particle, int d, double x) {
  return (d == 0 ? particle.axis + x : x) * cell;
}

/// What the nodes say to a particle of a field that they hold.
template <class M, class S>
Means find_means(const ParticleGeometry& particle, const NodeField& field) {
  constexpr int D = M::dimensions;
  const Patch patch = make_patch(D, reach);
  Means out;
  S::template support<M>(particle).for_each_node(
      patch,
      [&](int slot, double s, const double(&g)[extent<D>], double t) {
        double x[3] = {};
        for (int d = 0; d < D; ++d, slot /= patch.nodes)
          x[d] = position(particle, d, slot % patch.nodes);
        const double v = field(x);
        out.value += s * v;
        for (int d = 0; d < D; ++d) out.gradient[d] += g[d] * v;
        out.hoop += t * v;
      }
  );
  return out;
}

}  // namespace barreno::testing
