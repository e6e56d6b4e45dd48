// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/corner_support.hpp"
#include "shape/courant_table.hpp"
#include "shape/particle_geometry.hpp"

#include <cmath>
#include <utility>

namespace barreno {

/// Convected particle domain interpolation: the particle is a parallelogram (3D: parallelepiped)
/// with the half edges e_i = F e_i0, and the grid's functions are interpolated between its corners,
///
///   S_I = <sum_c M_c N_I(x_c)>,   grad S_I = <sum_c N_I(x_c) grad M_c>,
///
/// M_c the multilinear functions of the domain's own coordinates and < > the mean over the domain.
/// In axisymmetry the mean is weighted with r, T_I = int sum_c M_c N_I(x_c) dr dz / int r dr dz,
/// and a domain that reaches across the axis is narrowed there. Domains whose corners are further
/// than Largest Domain (l_crit) from x_p are scaled; F, volume and stress are not.
///
/// A particle whose F has a measure of zero or less is taken as undeformed until its policy acts.
///
/// Sources: A. Sadeghirad, R. Brannon, J. Burghardt, IJNME 86 (2011) 1435-1456; scaling: M. Homel,
/// R. Brannon, J. Guilkey, IJNME 107 (2016) 31-48; axisymmetric weights: docs/method.md 1.
struct Cpdi {
  static constexpr const char* word = "CPDI";
  static constexpr const char* warning = nullptr;
  static constexpr bool follows_deformation = true;
  static constexpr ParticleForm form = ParticleForm::parallelogram;
  /// V grad S = sum over the faces, everywhere.
  static constexpr double balanced_part = 1.0;
  static constexpr bool balanced_in_axisymmetry = true;
  static double unbalanced(double /*size*/) { return 0.0; }

  template <class M>
  using Support = CornerSupport<M::dimensions>;

  /// The rebuilt corners of three dimensions are up to 1.5 l_crit away (scale_domain).
  static int reach(const Scene& scene) {
    const double most = scene.step.largest_domain;
    return static_cast<int>(std::ceil(dimensions(scene.grid.mode) == 3 ? 1.5 * most : most));
  }

  /// e_i = F e_i0 [cells].
  template <int D>
  KOKKOS_FORCEINLINE_FUNCTION static Domain<D> deformed(const ParticleGeometry& particle) {
    Domain<D> out;
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) out.e[i][k] = particle.f[k][i] * particle.half[i];
    return out;
  }

  /// Whether F has turned the domain inside out or flat: its measure is at most 1e-12 of
  /// that of a rectangle with its edges.
  template <int D>
  KOKKOS_FORCEINLINE_FUNCTION static bool flat(const Domain<D>& domain) {
    double squares = 1.0;
    for (int i = 0; i < D; ++i) squares *= length_squared(domain.e[i]);
    return !(measure(domain) > 1e-12 * std::sqrt(squares));
  }

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static bool inverted(const ParticleGeometry& particle) {
    return flat(deformed<M::dimensions>(particle));
  }

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static bool clipped(const ParticleGeometry& particle) {
    return exceeds(deformed<M::dimensions>(particle), particle.largest);
  }

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static Domain<M::dimensions> domain(const ParticleGeometry& particle
  ) {
    constexpr int D = M::dimensions;
    Domain<D> out = deformed<D>(particle);
    const bool none = flat(out);
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k)
        out.e[i][k] = none ? (i == k ? particle.half[i] : 0.0) : out.e[i][k];
    double least = thinnest_half;
    for (int d = 0; d < D; ++d) least = particle.half[d] < least ? particle.half[d] : least;
    const double radius = particle.axis + particle.x[0];
    if constexpr (M::hoop) out = narrow_at_axis(out, radius);
    out = widen_domain(scale_domain(out, particle.largest), least);
    if constexpr (M::hoop) out = narrow_at_axis(out, radius);
    return out;
  }

  /// Half width of the domain where it is narrowest [cells].
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static double narrowest(const ParticleGeometry& particle) {
    const Domain<M::dimensions> slope = dual(domain<M>(particle));
    double steepest = length_squared(slope.e[0]);
    for (int i = 1; i < M::dimensions; ++i) {
      const double squared = length_squared(slope.e[i]);
      steepest = squared > steepest ? squared : steepest;
    }
    return 1.0 / std::sqrt(steepest);
  }

  /// A corner of a domain as a point of the grid. It is kept inside the patch and, in
  /// axisymmetry, off the other side of the axis, where round-off may carry it.
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static void put_corner(
      const ParticleGeometry& particle, const Domain<M::dimensions>& domain, int c, Support<M>& out
  ) {
    constexpr int D = M::dimensions;
    int slot = 0;
    for (int d = D - 1; d >= 0; --d) {
      double x = particle.x[d];
      for (int i = 0; i < D; ++i) x += Support<M>::sign(c, i) * domain.e[i][d];
      if (M::hoop && d == 0) x = x > -particle.axis ? x : -particle.axis;
      x = x > 0.0 ? x : 0.0;  // not a number: 0
      x = x < particle.last ? x : particle.last;
      double node = std::floor(x);
      node = node < particle.last - 1.0 ? node : particle.last - 1.0;
      out.at[c][d] = x - node;
      slot = slot * particle.row + static_cast<int>(node);
    }
    out.slot[c] = slot;
  }

  /// A call for each, no loop: compilers vectorise over the particles only what has none inside.
  template <class M, int... Corners>
  KOKKOS_FORCEINLINE_FUNCTION static void put_corners(
      const ParticleGeometry& particle,
      const Domain<M::dimensions>& domain,
      Support<M>& out,
      std::integer_sequence<int, Corners...> /*each*/
  ) {
    (put_corner<M>(particle, domain, Corners, out), ...);
  }
  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static void put_corners(
      const ParticleGeometry& particle, const Domain<M::dimensions>& domain, Support<M>& out
  ) {
    put_corners<M>(particle, domain, out, std::make_integer_sequence<int, Support<M>::corners>{});
  }

  template <class M>
  KOKKOS_FORCEINLINE_FUNCTION static Support<M> support(const ParticleGeometry& particle) {
    constexpr int D = M::dimensions;
    const Domain<D> edges = domain<M>(particle);
    const Domain<D> slope = dual(edges);
    Support<M> out;
    put_corners<M>(particle, edges, out);
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d) out.slope[i][d] = slope.e[i][d] * particle.per_cell;
    if constexpr (M::hoop) {
      const double per_radius = 1.0 / (particle.axis + particle.x[0]);
      for (int i = 0; i < 2; ++i) out.skew[i] = edges.e[i][0] * per_radius / 3.0;
      out.per_radius = per_radius * particle.per_cell;
    }
    return out;
  }

  /// Mean over one face, in axisymmetry weighted with r: the corners of that face twice, those of
  /// the opposite one not at all.
  template <class M>
  KOKKOS_INLINE_FUNCTION static Support<M> face_support(
      const ParticleGeometry& particle, int face
  ) {
    constexpr int D = M::dimensions;
    const int normal = face / 2;
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    Domain<D> edges = domain<M>(particle);
    ParticleGeometry centre = particle;
    for (int d = 0; d < D; ++d) {
      centre.x[d] += side * edges.e[normal][d];
      edges.e[normal][d] = 0.0;
    }
    Support<M> out;
    put_corners<M>(centre, edges, out);
    if constexpr (M::hoop) {
      const double radius = centre.axis + centre.x[0];
      out.skew[1 - normal] = radius > 0.0 ? edges.e[1 - normal][0] / (3.0 * radius) : 0.0;
    }
    return out;
  }

  static constexpr CourantTable courant_table{{1.002, 0.909, 0.781, 0.690, 0.498, 0.353}};
  static double critical_courant(double half_size_in_cells) {
    return courant_table.at(half_size_in_cells);
  }

  /// k = sum g^2 / S = 1 / (a (1 - a)) with an end on a node.
  static double isolated_courant(double half_size_in_cells) {
    const double a = half_size_in_cells;
    return std::sqrt(2.0 * a * (1.0 - a));
  }
};

}  // namespace barreno
