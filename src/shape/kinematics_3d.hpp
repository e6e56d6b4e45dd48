// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

#include <barreno/tensor.hpp>
#include <cmath>
#include <initializer_list>

namespace barreno {

/// Deformation gradient, or its increment, in three dimensions; rows xx xy xz, yx yy yz, zx zy zz.
struct SpaceTensor {
  double xx = 1.0, xy = 0.0, xz = 0.0;
  double yx = 0.0, yy = 1.0, yz = 0.0;
  double zx = 0.0, zy = 0.0, zz = 1.0;
};

/// A rotation as a unit quaternion: w + x i + y j + z k.
struct SpaceRotation {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

KOKKOS_INLINE_FUNCTION SpaceTensor multiply(const SpaceTensor& a, const SpaceTensor& b) {
  return {
      a.xx * b.xx + a.xy * b.yx + a.xz * b.zx,
      a.xx * b.xy + a.xy * b.yy + a.xz * b.zy,
      a.xx * b.xz + a.xy * b.yz + a.xz * b.zz,
      a.yx * b.xx + a.yy * b.yx + a.yz * b.zx,
      a.yx * b.xy + a.yy * b.yy + a.yz * b.zy,
      a.yx * b.xz + a.yy * b.yz + a.yz * b.zz,
      a.zx * b.xx + a.zy * b.yx + a.zz * b.zx,
      a.zx * b.xy + a.zy * b.yy + a.zz * b.zy,
      a.zx * b.xz + a.zy * b.yz + a.zz * b.zz};
}
KOKKOS_INLINE_FUNCTION SpaceTensor transpose(const SpaceTensor& a) {
  return {a.xx, a.yx, a.zx, a.xy, a.yy, a.zy, a.xz, a.yz, a.zz};
}
KOKKOS_INLINE_FUNCTION SpaceTensor scaled(double s, const SpaceTensor& a) {
  return {s * a.xx, s * a.xy, s * a.xz, s * a.yx, s * a.yy, s * a.yz, s * a.zx, s * a.zy, s * a.zz};
}
KOKKOS_INLINE_FUNCTION SpaceTensor plus(const SpaceTensor& a, const SpaceTensor& b) {
  return {
      a.xx + b.xx,
      a.xy + b.xy,
      a.xz + b.xz,
      a.yx + b.yx,
      a.yy + b.yy,
      a.yz + b.yz,
      a.zx + b.zx,
      a.zy + b.zy,
      a.zz + b.zz};
}
/// s I + a
KOKKOS_INLINE_FUNCTION SpaceTensor plus(double s, const SpaceTensor& a) {
  return {s + a.xx, a.xy, a.xz, a.yx, s + a.yy, a.yz, a.zx, a.zy, s + a.zz};
}
/// det(A) A^-T: takes an area vector N A to J F^-T N A (Nanson).
KOKKOS_INLINE_FUNCTION SpaceTensor cofactors(const SpaceTensor& a) {
  return {
      a.yy * a.zz - a.yz * a.zy,
      a.yz * a.zx - a.yx * a.zz,
      a.yx * a.zy - a.yy * a.zx,
      a.xz * a.zy - a.xy * a.zz,
      a.xx * a.zz - a.xz * a.zx,
      a.xy * a.zx - a.xx * a.zy,
      a.xy * a.yz - a.xz * a.yy,
      a.xz * a.yx - a.xx * a.yz,
      a.xx * a.yy - a.xy * a.yx};
}
KOKKOS_INLINE_FUNCTION double determinant(const SpaceTensor& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.zy) + a.xy * (a.yz * a.zx - a.yx * a.zz) +
         a.xz * (a.yx * a.zy - a.yy * a.zx);
}
/// Sum of the squares of the entries.
KOKKOS_INLINE_FUNCTION double norm_squared(const SpaceTensor& a) {
  return a.xx * a.xx + a.xy * a.xy + a.xz * a.xz + a.yx * a.yx + a.yy * a.yy + a.yz * a.yz +
         a.zx * a.zx + a.zy * a.zy + a.zz * a.zz;
}

KOKKOS_INLINE_FUNCTION double largest_entry(const SpaceTensor& a) {
  double largest = 0.0;
  for (const double x : {a.xx, a.xy, a.xz, a.yx, a.yy, a.yz, a.zx, a.zy, a.zz})
    largest = std::fmax(largest, std::fabs(x));
  return largest;
}

/// exp(A) of a tensor whose entries are at most 0.1 (docs/method.md). With t = tr A / 3, the
/// traceless B = A - t I obeys B^3 = p B + q I, p = tr(B^2) / 2, q = det B, so that
///
///   B^k = q z_(k-1) I + z_(k+1) B + z_k B^2,   z_(k+1) = p z_(k-1) + q z_(k-2),   z_2 = 1
///
/// and the power series of exp(B) needs scalars only; to B^13 it is exact to round-off. det exp(A)
/// = exp(tr A) then holds to round-off, which keeps the volume of a particle after many steps.
/// Without branches, for the compiler to vectorise.
///
/// The scalars are summed from their largest term, so that terms below a quarter of the last digit
/// change no bit: where entries are at most 3e-3, the series to B^7 has the bits of the one to
/// B^13.
template <int Order = 13>
KOKKOS_INLINE_FUNCTION SpaceTensor short_exponential(const SpaceTensor& a) {
  const double t = (a.xx + a.yy + a.zz) / 3.0;
  const SpaceTensor b{a.xx - t, a.xy, a.xz, a.yx, a.yy - t, a.yz, a.zx, a.zy, a.zz - t};
  const SpaceTensor b2 = multiply(b, b);
  const double p = 0.5 * (b2.xx + b2.yy + b2.zz);
  const double q = determinant(b);
  double before = 0.0, now = 0.0, next = 1.0;  // z_(k-1), z_k, z_(k+1) of k = 1
  double c0 = 1.0, c1 = 1.0, c2 = 0.0;         // of the series to k = 1
  double inverse = 1.0;                        // 1 / k!
  for (int k = 2; k <= Order; ++k) {
    const double after = p * now + q * before;
    before = now;
    now = next;
    next = after;
    inverse /= k;
    c0 += inverse * q * before;
    c1 += inverse * next;
    c2 += inverse * now;
  }
  // e^t by its own series: the same to round-off for |t| <= 0.1.
  double e = 1.0;
  for (int k = 10; k > 0; --k) e = 1.0 + e * t * (1.0 / k);
  c0 *= e;
  c1 *= e;
  c2 *= e;
  return {
      c0 + c1 * b.xx + c2 * b2.xx,
      c1 * b.xy + c2 * b2.xy,
      c1 * b.xz + c2 * b2.xz,
      c1 * b.yx + c2 * b2.yx,
      c0 + c1 * b.yy + c2 * b2.yy,
      c1 * b.yz + c2 * b2.yz,
      c1 * b.zx + c2 * b2.zx,
      c1 * b.zy + c2 * b2.zy,
      c0 + c1 * b.zz + c2 * b2.zz};
}

/// The same for any tensor: that of a 2^n-th part, squared n times.
KOKKOS_INLINE_FUNCTION SpaceTensor exponential(const SpaceTensor& a) {
  const double size = largest_entry(a);
  int squarings = 0;
  double part = 1.0;
  // An infinite tensor ends as one that is not finite.
  for (; size * part > 0.1 && squarings < 64; ++squarings) part *= 0.5;
  SpaceTensor out = short_exponential(scaled(part, a));
  for (int i = 0; i < squarings; ++i) out = multiply(out, out);
  return out;
}

KOKKOS_INLINE_FUNCTION SpaceRotation unit(const SpaceRotation& r) {
  const double inverse = 1.0 / std::sqrt(r.w * r.w + r.x * r.x + r.y * r.y + r.z * r.z);
  return {r.w * inverse, r.x * inverse, r.y * inverse, r.z * inverse};
}
/// First b, then a.
KOKKOS_INLINE_FUNCTION SpaceRotation multiply(const SpaceRotation& a, const SpaceRotation& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
KOKKOS_INLINE_FUNCTION SpaceRotation inverse(const SpaceRotation& r) {
  return {r.w, -r.x, -r.y, -r.z};
}
KOKKOS_INLINE_FUNCTION SpaceTensor matrix(const SpaceRotation& r) {
  const double xx = r.x * r.x, yy = r.y * r.y, zz = r.z * r.z;
  const double xy = r.x * r.y, xz = r.x * r.z, yz = r.y * r.z;
  const double wx = r.w * r.x, wy = r.w * r.y, wz = r.w * r.z;
  return {
      1.0 - 2.0 * (yy + zz),
      2.0 * (xy - wz),
      2.0 * (xz + wy),
      2.0 * (xy + wz),
      1.0 - 2.0 * (xx + zz),
      2.0 * (yz - wx),
      2.0 * (xz - wy),
      2.0 * (yz + wx),
      1.0 - 2.0 * (xx + yy)};
}

KOKKOS_INLINE_FUNCTION double norm_squared(const SpaceRotation& r) {
  return r.w * r.w + r.x * r.x + r.y * r.y + r.z * r.z;
}
/// |r|^2 times the matrix of the rotation that a quaternion of any length stands for.
KOKKOS_INLINE_FUNCTION SpaceTensor scaled_matrix(const SpaceRotation& r) {
  const double ww = r.w * r.w, xx = r.x * r.x, yy = r.y * r.y, zz = r.z * r.z;
  const double xy = r.x * r.y, xz = r.x * r.z, yz = r.y * r.z;
  const double wx = r.w * r.x, wy = r.w * r.y, wz = r.w * r.z;
  return {
      (ww + xx) - (yy + zz),
      2.0 * (xy - wz),
      2.0 * (xz + wy),
      2.0 * (xy + wz),
      (ww - xx) + (yy - zz),
      2.0 * (yz - wx),
      2.0 * (xz - wy),
      2.0 * (yz + wx),
      (ww - xx) - (yy - zz)};
}

/// R t R^T for the matrix of a rotation, or a multiple of it.
KOKKOS_INLINE_FUNCTION Sym3 turned(const SpaceTensor& r, const Sym3& t) {
  const SpaceTensor s =
      multiply(r, SpaceTensor{t.xx, t.xy, t.zx, t.xy, t.yy, t.yz, t.zx, t.yz, t.zz});
  return {
      s.xx * r.xx + s.xy * r.xy + s.xz * r.xz,
      s.yx * r.yx + s.yy * r.yy + s.yz * r.yz,
      s.zx * r.zx + s.zy * r.zy + s.zz * r.zz,
      s.xx * r.yx + s.xy * r.yy + s.xz * r.yz,
      s.yx * r.zx + s.yy * r.zy + s.yz * r.zz,
      s.zx * r.xx + s.zy * r.xy + s.zz * r.xz};
}
/// R t R^T: from the unrotated to the space frame.
KOKKOS_INLINE_FUNCTION Sym3 rotate(const SpaceRotation& r, const Sym3& t) {
  return turned(matrix(r), t);
}
/// R^T t R: from the space to the unrotated frame.
KOKKOS_INLINE_FUNCTION Sym3 unrotate(const SpaceRotation& r, const Sym3& t) {
  return rotate(inverse(r), t);
}

/// Half-way between two rotations less than half a turn apart; not of unit length.
KOKKOS_INLINE_FUNCTION SpaceRotation
sum_of_rotations(const SpaceRotation& a, const SpaceRotation& b) {
  const double same = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z >= 0.0 ? 1.0 : -1.0;
  return {a.w + same * b.w, a.x + same * b.x, a.y + same * b.y, a.z + same * b.z};
}
/// The same with unit length.
KOKKOS_INLINE_FUNCTION SpaceRotation mean_rotation(const SpaceRotation& a, const SpaceRotation& b) {
  return unit(sum_of_rotations(a, b));
}
/// unrotate() by the mean rotation of a and b, without a root.
KOKKOS_INLINE_FUNCTION Sym3
unrotate_between(const SpaceRotation& a, const SpaceRotation& b, const Sym3& t) {
  const SpaceRotation r = sum_of_rotations(a, b);
  const double per_square = 1.0 / norm_squared(r);
  const double s = per_square * per_square;
  return turned(
      scaled_matrix(inverse(r)), {s * t.xx, s * t.yy, s * t.zz, s * t.xy, s * t.yz, s * t.zx}
  );
}

/// What a rotation near R of F = R U lacks: by the Newton step of max tr(R^T F), with G = R^T F and
/// S its symmetric part, the turn w (in the frame of R) that solves
///
///   (tr(S) I - S) w = {Gzy - Gyz, Gxz - Gzx, Gyx - Gxy}
///
/// Errors are cubed by a step, because the third derivative vanishes along w at the solution.
/// Neither w nor the steps depend on the length of the quaternion.
struct RotationCorrection {
  double x, y, z;
};
KOKKOS_INLINE_FUNCTION RotationCorrection
rotation_correction(const SpaceTensor& f, const SpaceRotation& near) {
  const SpaceTensor g = multiply(scaled_matrix(inverse(near)), f);
  const double ax = g.zy - g.yz, ay = g.xz - g.zx, az = g.yx - g.xy;
  const double xx = g.yy + g.zz, yy = g.xx + g.zz, zz = g.xx + g.yy;
  const double xy = -0.5 * (g.xy + g.yx), xz = -0.5 * (g.xz + g.zx), yz = -0.5 * (g.yz + g.zy);
  const double cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
  const double cyy = xx * zz - xz * xz, cyz = xy * xz - xx * yz, czz = xx * yy - xy * xy;
  const double inverse = 1.0 / (xx * cxx + xy * cxy + xz * cxz);
  return {
      (cxx * ax + cxy * ay + cxz * az) * inverse,
      (cxy * ax + cyy * ay + cyz * az) * inverse,
      (cxz * ax + cyz * ay + czz * az) * inverse};
}
KOKKOS_INLINE_FUNCTION SpaceRotation
corrected(const SpaceRotation& r, const RotationCorrection& by) {
  return unit(multiply(r, SpaceRotation{1.0, 0.5 * by.x, 0.5 * by.y, 0.5 * by.z}));
}

/// R of F = R U from a rotation near it, by a Newton step; without branches.
/// @param[out] left  size of the step, squared: R is exact to round-off if it is at most
///                   `rotation_tolerance`
inline constexpr double rotation_tolerance = 1e-11;
KOKKOS_INLINE_FUNCTION SpaceRotation
nearer_polar_rotation(const SpaceTensor& f, const SpaceRotation& near, double& left) {
  const RotationCorrection by = rotation_correction(f, near);
  left = by.x * by.x + by.y * by.y + by.z * by.z;
  return corrected(near, by);
}
/// By two of them.
KOKKOS_INLINE_FUNCTION SpaceRotation
near_polar_rotation(const SpaceTensor& f, const SpaceRotation& near, double& left) {
  // Written out: compilers vectorise over particles only where they see no loop.
  return nearer_polar_rotation(f, nearer_polar_rotation(f, near, left), left);
}

/// R rotated by the spin of A, the antisymmetric part: R of exp(A) F but for what the stretch of
/// F makes of the strain of A, and for third order. Not of unit length: for Newton's method only.
KOKKOS_INLINE_FUNCTION SpaceRotation rotated_by_spin(const SpaceRotation& r, const SpaceTensor& a) {
  return multiply(
      SpaceRotation{1.0, 0.25 * (a.zy - a.yz), 0.25 * (a.xz - a.zx), 0.25 * (a.yx - a.xy)}, r
  );
}

/// Of a matrix that is a rotation to a few digits at least: from the largest of the four.
KOKKOS_INLINE_FUNCTION SpaceRotation rotation_of(const SpaceTensor& m) {
  const double w = m.xx + m.yy + m.zz, x = m.xx - m.yy - m.zz;
  const double y = m.yy - m.xx - m.zz, z = m.zz - m.xx - m.yy;
  if (w >= x && w >= y && w >= z) return unit({1.0 + w, m.zy - m.yz, m.xz - m.zx, m.yx - m.xy});
  if (x >= y && x >= z) return unit({m.zy - m.yz, 1.0 + x, m.xy + m.yx, m.xz + m.zx});
  if (y >= z) return unit({m.xz - m.zx, m.xy + m.yx, 1.0 + y, m.yz + m.zy});
  return unit({m.yx - m.xy, m.xz + m.zx, m.yz + m.zy, 1.0 + z});
}

/// A rotation to a few digits: scaled Newton iteration of the matrix, X <- (g X + X^-T / g) / 2.
///
/// Source: N. Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160-1174.
KOKKOS_INLINE_FUNCTION SpaceRotation rough_polar_rotation(const SpaceTensor& f) {
  SpaceTensor x = f;
  for (int i = 0; i < 20; ++i) {
    const double det = determinant(x);
    if (!(det > 0.0)) return {};  // no rotation, or not finite
    const SpaceTensor y = scaled(1.0 / det, cofactors(x));
    const double ratio = std::sqrt(norm_squared(y) / norm_squared(x));
    const double g = std::sqrt(ratio);
    x = plus(scaled(0.5 * g, x), scaled(0.5 / g, y));
    if (std::fabs(norm_squared(x) - 3.0) < 1e-10 && std::fabs(ratio - 1.0) < 1e-5) break;
  }
  return rotation_of(x);
}

/// U = R^T F is positive definite, as it is not at the other rotations for which it is symmetric.
KOKKOS_INLINE_FUNCTION bool stretches(const SpaceTensor& f, const SpaceRotation& r) {
  const SpaceTensor u = multiply(transpose(matrix(r)), f);
  return u.xx > 0.0 && u.xx * u.yy - u.xy * u.yx > 0.0 && determinant(u) > 0.0;
}

/// R of F = R U for any F with det F > 0, exact to round-off; fast from a rotation near it.
KOKKOS_INLINE_FUNCTION SpaceRotation
polar_rotation(const SpaceTensor& f, const SpaceRotation& near) {
  SpaceRotation r = near;
  double left = 1.0;
  for (int i = 0; i < 3; ++i) {
    r = near_polar_rotation(f, r, left);
    if (left <= rotation_tolerance && stretches(f, r)) return r;
  }
  return near_polar_rotation(f, rough_polar_rotation(f), left);
}
KOKKOS_INLINE_FUNCTION SpaceRotation polar_rotation(const SpaceTensor& f) {
  double left = 0.0;
  return near_polar_rotation(f, rough_polar_rotation(f), left);
}

/// Largest singular value of F: by how much the most stretched direction has grown. Root of the
/// largest eigenvalue of F^T F, by the trigonometric form of the cubic's roots.
KOKKOS_INLINE_FUNCTION double largest_stretch(const SpaceTensor& f) {
  const SpaceTensor c = multiply(transpose(f), f);
  const double mean = (c.xx + c.yy + c.zz) / 3.0;
  const double x = c.xx - mean, y = c.yy - mean, z = c.zz - mean;
  const double p =
      std::sqrt((x * x + y * y + z * z + 2.0 * (c.xy * c.xy + c.xz * c.xz + c.yz * c.yz)) / 6.0);
  if (!(p > 0.0)) return std::sqrt(mean);
  const double det = determinant(SpaceTensor{x, c.xy, c.xz, c.xy, y, c.yz, c.xz, c.yz, z});
  const double cosine = std::fmax(-1.0, std::fmin(1.0, 0.5 * det / (p * p * p)));
  return std::sqrt(mean + 2.0 * p * std::cos(std::acos(cosine) / 3.0));
}

}  // namespace barreno
