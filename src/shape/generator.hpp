// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/kinematics.hpp"

namespace barreno {

/// Where the gradient L of a step's velocities is taken: at the places before it or after it.
enum class Gradient { at_start, at_end };

/// Generator A of a step: exp(A) = f takes F to f F. Particles move straight, by dt v, so that the
/// body's points are taken by
///
///   f = I + dt L (L at the start)   or   f = (I - dt L)^-1 (at the end)
///
/// and with Z = dt L (2 I +- dt L)^-1,  A = log f = 2 (Z + Z^3 / 3 + Z^5 / 5 + ...), here to Z^5:
/// exp(A) is f to (dt L)^7 / 448. sym A is the strain of the step. A body that turns has orthogonal
/// f, then Z is antisymmetric and the strain nothing, however far it turns. (With exp(dt L) F falls
/// behind the positions by (w dt)^2 / 2 in every step: a spinning body swells by pi w dt in a
/// turn.) Entries beyond a half, with which 2 I +- dt L might have no inverse, give A = dt L.
///
/// Source: the Cayley transform; N. Higham, Functions of Matrices (SIAM 2008), 11.1.
inline constexpr double most_of_generator = 0.5;

/// Of one direction by itself: the hoop, or the plane's normal.
/// @param sign  1 for a gradient at the start, -1 at the end
KOKKOS_INLINE_FUNCTION double generator(double x, double sign) {
  const double z = x / (2.0 + sign * x);
  const double a = z * (2.0 + z * z * (2.0 / 3.0 + 0.4 * z * z));
  return std::fabs(x) <= most_of_generator ? a : x;
}

KOKKOS_INLINE_FUNCTION PlaneTensor scaled(double s, const PlaneTensor& a) {
  return {s * a.xx, s * a.xy, s * a.yx, s * a.yy, s * a.zz};
}
/// s I + a
KOKKOS_INLINE_FUNCTION PlaneTensor plus(double s, const PlaneTensor& a) {
  return {s + a.xx, a.xy, a.yx, s + a.yy, s + a.zz};
}
KOKKOS_INLINE_FUNCTION SpaceTensor plus(double s, const SpaceTensor& a) {
  return {s + a.xx, a.xy, a.xz, a.yx, s + a.yy, a.yz, a.zx, a.zy, s + a.zz};
}

/// Of the rows that a step takes together: no branches, for the compiler to vectorise.
KOKKOS_INLINE_FUNCTION PlaneTensor short_generator(const PlaneTensor& x, double sign) {
  const double mx = 2.0 + sign * x.xx, my = 2.0 + sign * x.yy;
  const double inverse = 1.0 / (mx * my - x.xy * x.yx);
  const PlaneTensor m{
      my * inverse, -sign * x.xy * inverse, -sign * x.yx * inverse, mx * inverse, 1.0};
  const PlaneTensor z = multiply(x, m);
  const PlaneTensor square = multiply(z, z);
  const PlaneTensor more = multiply(square, plus(2.0 / 3.0, scaled(0.4, square)));
  const PlaneTensor a = multiply(z, plus(2.0, more));
  return {a.xx, a.xy, a.yx, a.yy, generator(x.zz, sign)};
}

KOKKOS_INLINE_FUNCTION SpaceTensor short_generator(const SpaceTensor& x, double sign) {
  const SpaceTensor m = plus(2.0, scaled(sign, x));
  const SpaceTensor z = multiply(x, scaled(1.0 / determinant(m), transpose(cofactors(m))));
  const SpaceTensor square = multiply(z, z);
  const SpaceTensor more = multiply(square, plus(2.0 / 3.0, scaled(0.4, square)));
  return multiply(z, plus(2.0, more));
}

KOKKOS_INLINE_FUNCTION double largest_in_plane(const PlaneTensor& x) {
  return std::fmax(
      std::fmax(std::fabs(x.xx), std::fabs(x.yy)), std::fmax(std::fabs(x.xy), std::fabs(x.yx))
  );
}

/// The same for any tensor.
KOKKOS_INLINE_FUNCTION PlaneTensor generator(const PlaneTensor& x, double sign) {
  if (largest_in_plane(x) <= most_of_generator) return short_generator(x, sign);
  return {x.xx, x.xy, x.yx, x.yy, generator(x.zz, sign)};
}
KOKKOS_INLINE_FUNCTION SpaceTensor generator(const SpaceTensor& x, double sign) {
  return largest_entry(x) <= most_of_generator ? short_generator(x, sign) : x;
}

KOKKOS_INLINE_FUNCTION double sign_of(Gradient gradient) {
  return gradient == Gradient::at_start ? 1.0 : -1.0;
}

}  // namespace barreno
