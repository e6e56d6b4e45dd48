// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/courant_table.hpp"
#include "shape/tensor_shape.hpp"

namespace barreno {

/// B-splines of the grid at the particle's point: the particle is a mass at x_p, and a sum over
/// particles is an integral with one point for each,
///
///   S_I = N_I(x_p),   grad S_I = grad N_I(x_p),   in axisymmetry T_I = N_I(x_p) / r_p.
///
/// Its size enters nowhere but in the faces of a load. Degrees 2 and 3 end at the faces of the grid
/// with functions of their own (spline_weights).
template <class S, unsigned Degree>
struct SplineShape : TensorShape<S, Degree + 1> {
  static constexpr bool follows_deformation = false;
  static constexpr ParticleForm form = ParticleForm::point;

  template <bool Radial>
  KOKKOS_INLINE_FUNCTION static AxisWeights<Degree + 1> axis_weights(
      const ParticleGeometry& particle, int d
  ) {
    return spline_weights<Radial, Degree>(
        particle.x[d], particle.low[d], particle.high[d], particle.axis, particle.per_cell
    );
  }
  KOKKOS_INLINE_FUNCTION static AxisWeights<Degree + 1> face_weights(
      const ParticleGeometry& particle, int d, double side
  ) {
    const double x = particle.x[d] + side * particle.half[d];
    const double above = x > particle.low[d] ? x : particle.low[d];
    // The upper end belongs to the last cell.
    const double end = particle.high[d] * (1.0 - 1e-15);
    return on_massive_nodes(
        spline_weights<false, Degree>(
            above < end ? above : end,
            particle.low[d],
            particle.high[d],
            particle.axis,
            particle.per_cell
        ),
        axis_weights<false>(particle, d)
    );
  }

  /// A face reaches nodes that its particle's mass, a point, hardly reaches or not at all. A load
  /// would drive such a node without bound, and its velocity would tear the particle. So a face
  /// weighs most_face_weight times what the particle weighs, at most; the other nodes of the face
  /// take the rest. Where faces balance a uniform stress exactly the ratio is 4 or less.
  KOKKOS_INLINE_FUNCTION static AxisWeights<Degree + 1> on_massive_nodes(
      AxisWeights<Degree + 1> face, const AxisWeights<Degree + 1>& mass
  ) {
    constexpr double most_face_weight = 8.0;
    double sum = 0.0;
    for (int i = 0; i < face.n; ++i) {
      const int of_mass = face.first + i - mass.first;
      const bool reached = of_mass >= 0 && of_mass < mass.n;
      const double most = reached ? most_face_weight * mass.s[of_mass] : 0.0;
      if (face.s[i] > most) face.s[i] = most;
      sum += face.s[i];
    }
    if (sum < 1.0 - 1e-12)
      for (int i = 0; i < face.n; ++i) face.s[i] /= sum;
    return face;
  }
};

/// Linear functions. Their gradients jump at the nodes and particles that cross them bring noise,
/// so that the results do not converge: for comparison and teaching.
///
/// A node that only the edge of a particle's cell touches has next to no mass but a whole gradient:
/// no step is stable then (the critical Courant number tends to 0). The table holds the median over
/// the places of the particles instead of the minimum, and `barreno check` says so.
///
/// Source: D. Sulsky, Z. Chen, H. Schreyer, CMAME 118 (1994) 179-196.
struct Linear : SplineShape<Linear, 1> {
  static constexpr const char* word = "linear";
  static constexpr const char* warning =
      "linear shape functions have no lower bound on the stable step (nodes that barely touch a "
      "body have almost no mass): energy may grow at edges and where particles cross cells; use "
      "GIMP or CPDI except for comparison";
  /// V grad S = sum over the faces where all of the particle's box lies in one cell. Elsewhere a
  /// part of a face's force of up to `unbalanced` is left at some node, by its size in cells.
  static constexpr double balanced_part = 1.0;
  static constexpr bool balanced_in_axisymmetry = true;
  static double unbalanced(double size) { return size; }
  static int reach(const Scene& scene) { return scene.loads.empty() ? 0 : 1; }
  static constexpr CourantTable courant_table{{0.866, 0.884, 0.846, 0.819, 0.761, 0.725}};
  static double critical_courant(double half_size_in_cells) {
    return courant_table.at(half_size_in_cells);
  }
  /// The median over the places, as above.
  static double isolated_courant(double /*half_size_in_cells*/) { return 0.612; }
};

/// Quadratic B-splines, knots at the centres of the cells.
///
/// Source: M. Steffen, R. Kirby, M. Berzins, IJNME 76 (2008) 922-948.
struct QuadraticSpline : SplineShape<QuadraticSpline, 2> {
  static constexpr const char* word = "quadratic B-spline";
  static constexpr const char* warning = nullptr;
  /// The same where the box lies in half a cell, between two knots; in axisymmetry nowhere, because
  /// r dN/dr is quadratic there and one point does not integrate it.
  static constexpr double balanced_part = 0.5;
  static constexpr bool balanced_in_axisymmetry = false;
  static double unbalanced(double size) { return 0.4 * size * size; }
  static int reach(const Scene& /*scene*/) { return 1; }
  static constexpr CourantTable courant_table{{0.868, 0.960, 0.995, 1.023, 1.089, 1.153}};
  static double critical_courant(double half_size_in_cells) {
    return courant_table.at(half_size_in_cells);
  }
  /// k = sum g^2 / S = 6 where a third node comes into reach.
  static double isolated_courant(double /*half_size_in_cells*/) { return 0.577; }
};

/// Cubic B-splines, knots at the nodes.
struct CubicSpline : SplineShape<CubicSpline, 3> {
  static constexpr const char* word = "cubic B-spline";
  static constexpr const char* warning = nullptr;
  /// Nowhere: the gradient is quadratic, and one point does not integrate it.
  static constexpr double balanced_part = 0.0;
  static constexpr bool balanced_in_axisymmetry = false;
  static double unbalanced(double size) { return 0.25 * size * size; }
  static int reach(const Scene& scene) { return scene.loads.empty() ? 1 : 2; }
  static constexpr CourantTable courant_table{{1.404, 1.472, 1.489, 1.495, 1.499, 1.500}};
  static double critical_courant(double half_size_in_cells) {
    return courant_table.at(half_size_in_cells);
  }
  /// The largest sum g^2 / S over the places is 3.14.
  static double isolated_courant(double /*half_size_in_cells*/) { return 0.798; }
};

}  // namespace barreno
