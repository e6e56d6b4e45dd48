// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/kinematics.hpp"

namespace barreno {

/// Where the gradient L of a step's velocities is taken: at the places before it or after it.
enum class Gradient { at_start, at_end };

/// Generator A of a step, which takes F to exp(A) F; its symmetric part is the strain of the step.
/// Particles move straight, by dt v, so that a body that turns is taken by
///
///   f = I + dt L (L at the start)   or   f = (I - dt L)^-1 (at the end)
///
/// whose logarithm is, with Z = dt L (2 I +- dt L)^-1, 2 (Z + Z^3 / 3 + Z^5 / 5 + ...), here to Z^5
/// (off by (dt L)^7 / 448). With E its symmetric part
///
///   A = log f +- E^2 / 2
///
/// A rotation f has an antisymmetric Z: it strains nothing, and F turns with the positions however
/// far they turn. (With A = dt L, F falls behind them by (w dt)^2 / 2 in every step, and a spinning
/// body swells by pi w dt in a turn.) Without rotation A is dt L to third order: stretching is the
/// exponential of its rate, as the hoop's is. With A = log f there too, CPDI's domains meet to
/// round-off instead of a thousandth, but a bar of them breaks up where they are longer than two
/// cells and aligned with the grid (verification/cases/extension.py).
/// Entries beyond a half, with which 2 I +- dt L might be singular, give A = dt L.
///
/// Source: the Cayley transform; N. Higham, Functions of Matrices (SIAM 2008), 11.1.
inline constexpr double generator_limit = 0.5;

KOKKOS_INLINE_FUNCTION PlaneTensor scaled(double s, const PlaneTensor& a) {
  return {s * a.xx, s * a.xy, s * a.yx, s * a.yy, s * a.zz};
}
/// s I + a
KOKKOS_INLINE_FUNCTION PlaneTensor plus(double s, const PlaneTensor& a) {
  return {s + a.xx, a.xy, a.yx, s + a.yy, s + a.zz};
}

/// 2 (Z + Z^3 / 3 + Z^5 / 5)
template <class Tensor>
KOKKOS_INLINE_FUNCTION Tensor series_of_log(const Tensor& z) {
  const Tensor square = multiply(z, z);
  const Tensor more = multiply(square, plus(2.0 / 3.0, scaled(0.4, square)));
  return multiply(z, plus(2.0, more));
}

/// The same in three dimensions, by Z^3 = t Z^2 - s Z + d I (t: trace, s: second invariant, d:
/// determinant), which leaves a polynomial of second degree.
KOKKOS_INLINE_FUNCTION SpaceTensor series_of_log(const SpaceTensor& z) {
  const SpaceTensor z2 = multiply(z, z);
  const double t = z.xx + z.yy + z.zz;
  const double s = 0.5 * (t * t - (z2.xx + z2.yy + z2.zz));
  const double d = determinant(z);
  // Z^5 = (t (t^2 - 2 s) + d) Z^2 + (s^2 - t^2 s + t d) Z + (t^2 - s) d I
  const double tt = t * t;
  const double c2 = 2.0 / 3.0 * t + 0.4 * (t * (tt - 2.0 * s) + d);
  const double c1 = 2.0 - 2.0 / 3.0 * s + 0.4 * (s * s - tt * s + t * d);
  const double c0 = d * (2.0 / 3.0 + 0.4 * (tt - s));
  return plus(c0, plus(scaled(c1, z), scaled(c2, z2)));
}

/// For small entries, without branches, for the compiler to vectorise. The hoop, or the plane's
/// normal, only stretches.
/// @param sign  1 for a gradient at the start, -1 at the end
KOKKOS_FORCEINLINE_FUNCTION PlaneTensor short_generator(const PlaneTensor& x, double sign) {
  const double mx = 2.0 + sign * x.xx, my = 2.0 + sign * x.yy;
  const double inverse = 1.0 / (mx * my - x.xy * x.yx);
  const PlaneTensor m{
      my * inverse, -sign * x.xy * inverse, -sign * x.yx * inverse, mx * inverse, 0.0};
  const PlaneTensor a = series_of_log(multiply(x, m));
  const double shear = 0.5 * (a.xy + a.yx);
  const double half = 0.5 * sign;
  const double across = half * shear * (a.xx + a.yy);
  return {
      a.xx + half * (a.xx * a.xx + shear * shear),
      a.xy + across,
      a.yx + across,
      a.yy + half * (a.yy * a.yy + shear * shear),
      x.zz};
}

KOKKOS_FORCEINLINE_FUNCTION SpaceTensor short_generator(const SpaceTensor& x, double sign) {
  const SpaceTensor m = plus(2.0, scaled(sign, x));
  const SpaceTensor inverse = scaled(1.0 / determinant(m), transpose(cofactors(m)));
  const SpaceTensor a = series_of_log(multiply(x, inverse));
  const double xy = 0.5 * (a.xy + a.yx), yz = 0.5 * (a.yz + a.zy), zx = 0.5 * (a.zx + a.xz);
  const SpaceTensor e{a.xx, xy, zx, xy, a.yy, yz, zx, yz, a.zz};
  return plus(a, scaled(0.5 * sign, multiply(e, e)));
}

KOKKOS_INLINE_FUNCTION double largest_in_plane(const PlaneTensor& x) {
  return std::fmax(
      std::fmax(std::fabs(x.xx), std::fabs(x.yy)), std::fmax(std::fabs(x.xy), std::fabs(x.yx))
  );
}

/// The same for any tensor.
KOKKOS_INLINE_FUNCTION PlaneTensor generator(const PlaneTensor& x, double sign) {
  return largest_in_plane(x) <= generator_limit ? short_generator(x, sign) : x;
}
KOKKOS_INLINE_FUNCTION SpaceTensor generator(const SpaceTensor& x, double sign) {
  return largest_entry(x) <= generator_limit ? short_generator(x, sign) : x;
}

KOKKOS_INLINE_FUNCTION double sign_of(Gradient gradient) {
  return gradient == Gradient::at_start ? 1.0 : -1.0;
}

}  // namespace barreno
