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
  static constexpr double max_half = 1.0;

  static int reach(const Scene& /*scene*/) { return 1; }

  KOKKOS_INLINE_FUNCTION static double largest_half(const ParticleGeometry& particle) {
    return particle.largest < max_half ? particle.largest : max_half;
  }

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static bool clipped(const ParticleGeometry& particle) {
    bool out = false;
    for (int d = 0; d < M::dimensions; ++d)
      out = out | !(particle.half[d] * particle.stretch[d] <= largest_half(particle));
    return out;
  }

  /// A box cannot be inverted; only a stretch that is not positive counts.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static bool inverted(const ParticleGeometry& particle) {
    bool out = false;
    for (int d = 0; d < M::dimensions; ++d) out = out | !(particle.stretch[d] > 0.0);
    return out;
  }

  /// The particle with its half sizes stretched and cut.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static ParticleGeometry stretched(ParticleGeometry particle) {
    const double most = largest_half(particle);
    for (int d = 0; d < M::dimensions; ++d) {
      const double wanted = particle.half[d] * particle.stretch[d];
      const double least = particle.half[d] < thinnest_half ? particle.half[d] : thinnest_half;
      const double wide = wanted < least ? least : wanted;
      particle.half[d] = wide < most ? wide : most;  // not a number: the largest
    }
    return particle;
  }

  /// Half width of the box where it is narrowest [cells].
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static double narrowest(const ParticleGeometry& particle) {
    const ParticleGeometry own = stretched<M>(particle);
    double least = own.half[0];
    for (int d = 1; d < M::dimensions; ++d) least = own.half[d] < least ? own.half[d] : least;
    return least;
  }

  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> support(const ParticleGeometry& particle) {
    return TensorShape::support<M>(stretched<M>(particle));
  }
  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> face_support(
      const ParticleGeometry& particle, int face
  ) {
    return TensorShape::face_support<M>(stretched<M>(particle), face);
  }

  template <bool Radial>
  KOKKOS_INLINE_FUNCTION static AxisWeights<4> axis_weights(
      const ParticleGeometry& particle, int d
  ) {
    double a = particle.x[d] - particle.half[d];
    const double b = particle.x[d] + particle.half[d];
    if constexpr (Radial) a = a > -particle.axis ? a : -particle.axis;
    return average_hats<Radial, 4>(
        a, b, first_of<4>(particle, a), particle.axis, particle.per_cell
    );
  }
  KOKKOS_INLINE_FUNCTION static AxisWeights<4> face_weights(
      const ParticleGeometry& particle, int d, double side
  ) {
    const double x = particle.x[d] + side * particle.half[d];
    return hats_at<4>(x, first_of<4>(particle, x));
  }

  /// Of the undeformed particles, as for GIMP.
  static constexpr CourantTable courant_table{{0.868, 0.804, 0.732, 0.665, 0.493, 0.352}};
  static double critical_courant(double half_size_in_cells) {
    return courant_table.at(half_size_in_cells);
  }

  /// As for GIMP: k = sum g^2 / S is 1 / (a (1 - a)) where the box lies in one cell and 1 / a more
  /// where it touches a third node.
  static double isolated_courant(double half_size_in_cells) {
    const double a = half_size_in_cells;
    return std::sqrt(2.0 * a * (1.0 - a) / (2.0 - a));
  }
};

}  // namespace barreno
