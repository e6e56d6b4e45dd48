// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/courant_table.hpp"
#include "shape/tensor_shape.hpp"

#include <cmath>

namespace barreno {

/// Uniform GIMP: the particle is a box of its undeformed size around x_p, at most one cell wide.
///
///   S_I = average of N_I over the box,  grad S_I = average of grad N_I,
///
/// in axisymmetry weighted with r; there T_I = int N_I dr / int r dr gives the hoop strain, and a
/// box that reaches across the axis is cut at it. The integrals are exact for any half size, so
/// that the sums of S, of grad S and the uniform strain states are too (docs/method.md).
///
/// Source: S. Bardenhagen, E. Kober, CMES 5 (2004) 477-495; r-weighting: J. Nairn, J. Guilkey,
/// IJNME 101 (2015) 127-147.
struct Gimp : TensorShape<Gimp, 3> {
  static constexpr const char* word = "GIMP";
  static constexpr const char* warning = nullptr;
  static constexpr bool follows_deformation = false;
  static constexpr ParticleForm form = ParticleForm::box;
  /// V grad S = sum over the faces, everywhere.
  static constexpr double balanced_part = 1.0;
  static constexpr bool balanced_in_axisymmetry = true;
  static double unbalanced(double /*size*/) { return 0.0; }

  /// Nodes beyond its own tile that a particle can give to.
  static int reach(const Scene& /*scene*/) { return 1; }

  /// [a, b] in cells, b - a <= 1, split at the node inside it: part [a, c] lies in the first cell,
  /// [1, e] in the second, and either may be empty.
  template <bool Radial>
  KOKKOS_INLINE_FUNCTION static AxisWeights<3> axis_weights(
      const ParticleGeometry& particle, int d
  ) {
    const double axis = particle.axis;
    const double per_cell = particle.per_cell;
    double a = particle.x[d] - particle.half[d];
    double b = particle.x[d] + particle.half[d];
    // Selections instead of fmin and fmax, which do not vectorise.
    if constexpr (Radial) a = a > -axis ? a : -axis;
    const double base = std::floor(a);
    a -= base;
    b -= base;
    const double c = b < 1.0 ? b : 1.0;
    const double e = b < 1.0 ? 1.0 : b;
    const double w1 = c - a;
    const double w2 = e - 1.0;
    const double m1 = 0.5 * (a + c);
    const double m2 = 0.5 * (1.0 + e);
    AxisWeights<3> out;
    out.first = static_cast<int>(base);
    if constexpr (Radial) {
      const double r1 = axis + base + m1;
      const double r2 = axis + base + m2;
      const double inverse = 1.0 / (w1 * r1 + w2 * r2);
      const double hoop = inverse * per_cell;
      out.s[0] = (w1 * (1.0 - m1) * r1 - w1 * w1 * w1 / 12.0) * inverse;
      out.s[2] = (w2 * (m2 - 1.0) * r2 + w2 * w2 * w2 / 12.0) * inverse;
      out.g[0] = -w1 * r1 * hoop;
      out.g[2] = w2 * r2 * hoop;
      out.t[0] = w1 * (1.0 - m1) * hoop;
      out.t[2] = w2 * (m2 - 1.0) * hoop;
      out.t[1] = (w1 + w2) * hoop - out.t[0] - out.t[2];
    } else {
      const double inverse = 1.0 / (w1 + w2);
      out.s[0] = w1 * (1.0 - m1) * inverse;
      out.s[2] = w2 * (m2 - 1.0) * inverse;
      out.g[0] = -w1 * inverse * per_cell;
      out.g[2] = w2 * inverse * per_cell;
    }
    out.s[1] = 1.0 - out.s[0] - out.s[2];
    out.g[1] = -out.g[0] - out.g[2];
    return out;
  }

  /// sum_p V_p grad S_p of a body is then exactly the sum over its outer faces, and a body under
  /// uniform pressure is in exact equilibrium.
  KOKKOS_INLINE_FUNCTION static AxisWeights<3> face_weights(
      const ParticleGeometry& particle, int d, double side
  ) {
    const double x = particle.x[d] + side * particle.half[d];
    return hats_at<3>(x, first_of<3>(particle, x));
  }

  static constexpr CourantTable courant_table{{0.868, 0.804, 0.732, 0.665, 0.493, 0.352}};
  static double critical_courant(double half_size_in_cells) {
    return courant_table.at(half_size_in_cells);
  }

  /// k = sum g^2 / S is 1 / (a (1 - a)) where the box lies in one cell and 1 / a more where it
  /// touches a third node.
  static double isolated_courant(double half_size_in_cells) {
    const double a = half_size_in_cells;
    return std::sqrt(2.0 * a * (1.0 - a) / (2.0 - a));
  }
};

}  // namespace barreno
