// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/courant_table.hpp"
#include "shape/tensor_shape.hpp"

#include <cmath>

namespace barreno {

/// Contiguous-particle GIMP: the box around x_p follows the particle's stretch along each axis,
///
///   half size = U_ii times that of the undeformed particle,   F = R U,
///
/// so that neighbours in a stretched or compressed body stay in touch; averages as for GIMP. The
/// stretch tensor U does not know rotation: F_ii would shrink a particle that turns. Shear and
/// large rotation leave gaps and overlaps; CPDI follows them too. Half sizes are cut at Largest
/// Domain and at one cell, and such particles are counted as clipped.
///
/// Sources: S. Bardenhagen, E. Kober, CMES 5 (2004) 477-495; U_ii: T. Charlton, W. Coombs,
/// C. Augarde, Computers and Structures 190 (2017) 108-125.
struct ContiguousGimp : TensorShape<ContiguousGimp, 4> {
  static constexpr const char* word = "contiguous GIMP";
  static constexpr const char* warning = nullptr;
  static constexpr bool follows_deformation = true;
  static constexpr ParticleForm form = ParticleForm::box;
  /// V grad S = sum over the faces, everywhere while U is diagonal.
  static constexpr double balanced_part = 1.0;
  static constexpr bool balanced_in_axisymmetry = true;
  static double unbalanced(double /*size*/) { return 0.0; }

  /// Four nodes hold a box of two cells.
  static constexpr double most_half = 1.0;

  static int reach(const Scene& /*scene*/) { return 1; }

  KOKKOS_INLINE_FUNCTION static double largest_half(const ParticlePlace& place) {
    return place.largest < most_half ? place.largest : most_half;
  }

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static bool clipped(const ParticlePlace& place) {
    bool out = false;
    for (int d = 0; d < M::dimensions; ++d)
      out = out | !(place.half[d] * place.stretch[d] <= largest_half(place));
    return out;
  }

  /// A box has no inside to turn out; only a stretch that is none counts.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static bool inverted(const ParticlePlace& place) {
    bool out = false;
    for (int d = 0; d < M::dimensions; ++d) out = out | !(place.stretch[d] > 0.0);
    return out;
  }

  /// The place with its half sizes stretched and cut.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static ParticlePlace stretched(ParticlePlace place) {
    const double most = largest_half(place);
    for (int d = 0; d < M::dimensions; ++d) {
      const double wanted = place.half[d] * place.stretch[d];
      const double least = place.half[d] < thinnest_half ? place.half[d] : thinnest_half;
      const double wide = wanted < least ? least : wanted;
      place.half[d] = wide < most ? wide : most;  // not a number: the largest
    }
    return place;
  }

  /// Half width of the box where it is narrowest [cells].
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static double narrowest(const ParticlePlace& place) {
    const ParticlePlace own = stretched<M>(place);
    double least = own.half[0];
    for (int d = 1; d < M::dimensions; ++d) least = own.half[d] < least ? own.half[d] : least;
    return least;
  }

  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> support(const ParticlePlace& place) {
    return TensorShape::support<M>(stretched<M>(place));
  }
  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> face_support(const ParticlePlace& place, int face) {
    return TensorShape::face_support<M>(stretched<M>(place), face);
  }

  template <bool Radial>
  KOKKOS_INLINE_FUNCTION static AxisWeights<4> axis_weights(const ParticlePlace& place, int d) {
    double a = place.x[d] - place.half[d];
    const double b = place.x[d] + place.half[d];
    if constexpr (Radial) a = a > -place.axis ? a : -place.axis;
    return average_hats<Radial, 4>(a, b, first_of<4>(place, a), place.axis, place.per_cell);
  }
  KOKKOS_INLINE_FUNCTION static AxisWeights<4> face_weights(
      const ParticlePlace& place, int d, double side
  ) {
    const double x = place.x[d] + side * place.half[d];
    return hats_at<4>(x, first_of<4>(place, x));
  }

  /// Of the undeformed particles, as for GIMP.
  static double critical_courant(double half_size_in_cells) {
    return CourantTable{{0.868, 0.804, 0.732, 0.665, 0.493, 0.352}}.at(half_size_in_cells);
  }

  /// As for GIMP: k = sum g^2 / S is 1 / (a (1 - a)) where the box lies in one cell and 1 / a more
  /// where it touches a third node.
  static double lone_courant(double half_size_in_cells) {
    const double a = half_size_in_cells;
    return std::sqrt(2.0 * a * (1.0 - a) / (2.0 - a));
  }
};

}  // namespace barreno
