// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/tensor_support.hpp"

#include <cmath>

namespace barreno {

/// Where a particle is, in units of cells. `x` counts from the first node of the tile's patch;
/// `axis` is the radius of that node, so that r = axis + x[0] (axisymmetry only).
struct ParticlePlace {
  double x[3] = {};
  double half[3] = {};  ///< half edges of the undeformed particle
  double axis = 0.0;
  double per_cell = 1.0;  ///< 1 / cell size
  int row = 0;            ///< slots from one row of the patch to the next
};

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
struct Gimp {
  static constexpr const char* word = "GIMP";

  /// Nodes beyond its own tile that a particle can give to.
  static int reach(const Scene& /*scene*/) { return 1; }

  /// Weights along one axis: three nodes from `first` on.
  struct Axis {
    int first = 0;
    double s[3]{};  ///< averages of N
    double g[3]{};  ///< averages of dN/dx [1/length]
    double t[3]{};  ///< int N dr / int r dr [1/length]; radial axis only
  };

  /// [a, b] in cells, b - a <= 1, split at the node inside it: part [a, c] lies in the first cell,
  /// [1, e] in the second, and either may be empty.
  template <bool Radial>
  KOKKOS_INLINE_FUNCTION static Axis axis_weights(
      double x, double half, double axis, double per_cell
  ) {
    double a = x - half;
    double b = x + half;
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
    Axis out;
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

  /// Linear hat functions at a point: weights of a particle's face along its normal.
  KOKKOS_INLINE_FUNCTION static Axis point_weights(double x) {
    const double base = std::floor(x);
    Axis out;
    out.first = static_cast<int>(base);
    out.s[1] = x - base;
    out.s[0] = 1.0 - out.s[1];
    return out;
  }

  template <class M>
  using Support = TensorSupport<M::dimensions, 3>;

  KOKKOS_INLINE_FUNCTION static TensorSupport<2, 3> product(const Axis& x, const Axis& y, int row) {
    return {
        y.first * row + x.first,
        {x.s[0], x.s[1], x.s[2]},
        {x.g[0], x.g[1], x.g[2]},
        {x.t[0], x.t[1], x.t[2]},
        {y.s[0], y.s[1], y.s[2]},
        {y.g[0], y.g[1], y.g[2]}};
  }

  KOKKOS_INLINE_FUNCTION static TensorSupport<3, 3> product(
      const Axis& x, const Axis& y, const Axis& z, int row
  ) {
    return {
        (z.first * row + y.first) * row + x.first,
        {x.s[0], x.s[1], x.s[2]},
        {x.g[0], x.g[1], x.g[2]},
        {y.s[0], y.s[1], y.s[2]},
        {y.g[0], y.g[1], y.g[2]},
        {z.s[0], z.s[1], z.s[2]},
        {z.g[0], z.g[1], z.g[2]}};
  }

  /// Product of the weights that `along(axis)` gives.
  template <class M, class Along>
  KOKKOS_INLINE_FUNCTION static Support<M> product(int row, const Along& along) {
    if constexpr (M::dimensions == 3)
      return product(along(0), along(1), along(2), row);
    else
      return product(along(0), along(1), row);
  }
  template <class M>
  KOKKOS_INLINE_FUNCTION static Axis weights_along(const ParticlePlace& place, int axis) {
    if (M::hoop && axis == 0)
      return axis_weights<true>(place.x[0], place.half[0], place.axis, place.per_cell);
    return axis_weights<false>(place.x[axis], place.half[axis], 0.0, place.per_cell);
  }

  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> support(const ParticlePlace& place) {
    return product<M>(place.row, [&](int axis) { return weights_along<M>(place, axis); });
  }

  /// Average of N over one face of the particle (0: x_lower, 1: x_upper, 2: y_lower and so on), the
  /// weight of a pressure on it. sum_p V_p grad S_p of a body is then exactly the sum over its
  /// outer faces, and a body under uniform pressure is in exact equilibrium.
  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> face_support(const ParticlePlace& place, int face) {
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    return product<M>(place.row, [&](int axis) {
      return axis == face / 2 ? point_weights(place.x[axis] + side * place.half[axis])
                              : weights_along<M>(place, axis);
    });
  }

  /// Critical Courant number c dt / h of a free bar (docs/method.md), by the half size in cells:
  /// the minimum over all places of the particles in their cells.
  static double critical_courant(double half_size_in_cells) {
    constexpr double half[4] = {0.125, 1.0 / 6.0, 0.25, 0.5};
    constexpr double limit[4] = {0.665, 0.732, 0.804, 0.868};
    if (half_size_in_cells <= half[0]) return limit[0] * half_size_in_cells / half[0];
    for (int i = 1; i < 4; ++i)
      if (half_size_in_cells <= half[i])
        return limit[i - 1] + (limit[i] - limit[i - 1]) * (half_size_in_cells - half[i - 1]) /
                                  (half[i] - half[i - 1]);
    return limit[3];
  }
};

}  // namespace barreno
