// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "base/types.hpp"
#include "scene/scene.hpp"
#include "shape/kinematics_3d.hpp"

#include <barreno/tensor.hpp>
#include <cmath>
#include <utility>

namespace barreno {

/// Deformation gradient, or its increment, of a two-dimensional mode: in-plane part and hoop
/// stretch.
struct PlaneTensor {
  double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0, zz = 1.0;
};
/// Rotation of a plane, stored as cosine and sine.
struct PlaneRotation {
  double c = 1.0, s = 0.0;
};

/// Compile-time facts of a mode; the kernels are compiled once per mode.
struct Axisymmetric {
  static constexpr int dimensions = 2;
  static constexpr bool hoop = true;
  static constexpr int deformation_components = 5;
  using Tensor = PlaneTensor;
};
struct PlaneStrain {
  static constexpr int dimensions = 2;
  static constexpr bool hoop = false;
  static constexpr int deformation_components = 4;
  using Tensor = PlaneTensor;
};
struct ThreeDimensional {
  static constexpr int dimensions = 3;
  static constexpr bool hoop = false;
  static constexpr int deformation_components = 9;
  using Tensor = SpaceTensor;
};

/// Every mode; tests run over it.
template <class... Modes>
struct ModeList {};
using AllModes = ModeList<Axisymmetric, PlaneStrain, ThreeDimensional>;

template <class F>
decltype(auto) visit_mode(Mode mode, F&& f) {
  if (mode == Mode::axisymmetric) return std::forward<F>(f)(Axisymmetric{});
  if (mode == Mode::plane_strain) return std::forward<F>(f)(PlaneStrain{});
  return std::forward<F>(f)(ThreeDimensional{});
}

/// The tensor of a row of F or of dt L; `missing` is the hoop entry of plane strain, 1 and 0.
template <class M, class Columns>
KOKKOS_INLINE_FUNCTION typename M::Tensor load_tensor(
    const Columns& v, int p, double missing = 1.0
) {
  if constexpr (M::dimensions == 3)
    return {v(p, 0), v(p, 1), v(p, 2), v(p, 3), v(p, 4), v(p, 5), v(p, 6), v(p, 7), v(p, 8)};
  else
    return {v(p, 0), v(p, 1), v(p, 2), v(p, 3), M::hoop ? v(p, 4) : missing};
}
template <class M>
KOKKOS_INLINE_FUNCTION void store_tensor(const typename M::Tensor& f, const FieldView& v, int p) {
  v(p, 0) = f.xx;
  v(p, 1) = f.xy;
  if constexpr (M::dimensions == 3) {
    v(p, 2) = f.xz;
    v(p, 3) = f.yx;
    v(p, 4) = f.yy;
    v(p, 5) = f.yz;
    v(p, 6) = f.zx;
    v(p, 7) = f.zy;
    v(p, 8) = f.zz;
  } else {
    v(p, 2) = f.yx;
    v(p, 3) = f.yy;
    if constexpr (M::hoop) v(p, 4) = f.zz;
  }
}

KOKKOS_INLINE_FUNCTION double determinant(const PlaneTensor& f) {
  return (f.xx * f.yy - f.xy * f.yx) * f.zz;
}
/// det(F) F^-T: takes an area vector N A to J F^-T N A (Nanson).
KOKKOS_INLINE_FUNCTION PlaneTensor cofactors(const PlaneTensor& f) {
  return {f.yy * f.zz, -f.yx * f.zz, -f.xy * f.zz, f.xx * f.zz, f.xx * f.yy - f.xy * f.yx};
}

/// Largest singular value of F: by how much the most stretched direction has grown.
KOKKOS_INLINE_FUNCTION double largest_stretch(const PlaneTensor& f) {
  const double sum = 0.5 * (f.xx * f.xx + f.xy * f.xy + f.yx * f.yx + f.yy * f.yy);
  const double det = f.xx * f.yy - f.xy * f.yx;
  const double root = std::sqrt(std::fabs(sum * sum - det * det));  // >= 0 but for round-off
  const double in_plane = std::sqrt(sum + root);
  return in_plane > f.zz ? in_plane : f.zz;
}

/// R of F = R U in two dimensions, exact: the direction of (Fxx + Fyy, Fyx - Fxy). A matrix without
/// a direction (both zero) has no rotation.
KOKKOS_INLINE_FUNCTION PlaneRotation direction(double c, double s) {
  const double n = std::sqrt(c * c + s * s);
  const double inverse = n > 0.0 ? 1.0 / n : 0.0;
  return {n > 0.0 ? c * inverse : 1.0, s * inverse};
}
KOKKOS_INLINE_FUNCTION PlaneRotation polar_rotation(const PlaneTensor& f) {
  return direction(f.xx + f.yy, f.yx - f.xy);
}

/// R of a particle. The plane's follows from F; in three dimensions it is kept beside F.
/// @param deformation,rotation  FieldView, or BatchColumns with p in the batch
template <class M, class Columns, class OtherColumns>
KOKKOS_INLINE_FUNCTION auto load_rotation(
    const Columns& deformation, const OtherColumns& rotation, int p
) {
  if constexpr (M::dimensions == 3)
    return SpaceRotation{rotation(p, 0), rotation(p, 1), rotation(p, 2), rotation(p, 3)};
  else
    return polar_rotation(load_tensor<M>(deformation, p));
}

/// Half-way between the polar rotations of two tensors, which are less than half a turn apart.
KOKKOS_INLINE_FUNCTION PlaneRotation
mean_polar_rotation(const PlaneTensor& f, const PlaneTensor& g) {
  const double fc = f.xx + f.yy;
  const double fs = f.yx - f.xy;
  const double gc = g.xx + g.yy;
  const double gs = g.yx - g.xy;
  const double fn = std::sqrt(fc * fc + fs * fs);
  const double gn = std::sqrt(gc * gc + gs * gs);
  return direction(gn * fc + fn * gc, gn * fs + fn * gs);
}

/// R t R^T: from the unrotated to the space frame.
KOKKOS_INLINE_FUNCTION Sym3 rotate(const PlaneRotation& r, const Sym3& t) {
  const double cc = r.c * r.c;
  const double ss = r.s * r.s;
  const double cs = r.c * r.s;
  return {
      cc * t.xx - 2.0 * cs * t.xy + ss * t.yy,
      ss * t.xx + 2.0 * cs * t.xy + cc * t.yy,
      t.zz,
      cs * (t.xx - t.yy) + (cc - ss) * t.xy,
      0.0,
      0.0};
}

/// R^T t R: from the space to the unrotated frame.
KOKKOS_INLINE_FUNCTION Sym3 unrotate(const PlaneRotation& r, const Sym3& t) {
  return rotate(PlaneRotation{r.c, -r.s}, t);
}

/// Largest entry of dt L for which the short series of the exponential are exact to round-off.
inline constexpr double short_series = 0.1;
/// The same for shorter series, with the same bits.
inline constexpr double shorter_series = 3e-3;

/// Whether components [first, last) of dt L of all rows are within that, or another limit.
inline bool all_short(
    const FieldView& increment, Rows rows, int first, int last, double limit = short_series
) {
  int large = 0;
  launch_reduction(
      "all_short",
      range((rows.end - rows.begin + rows_per_chunk - 1) / rows_per_chunk),
      KOKKOS_LAMBDA(const int chunk, int& some) {
        const int begin = rows.begin + chunk * rows_per_chunk;
        const int end = begin + rows_per_chunk < rows.end ? begin + rows_per_chunk : rows.end;
        if (rows.skips(begin)) return;
        int here = 0;
        for (int c = first; c < last; ++c)
          for (int p = begin; p < end; ++p)
            here |= static_cast<int>(!(std::abs(increment(p, c)) <= limit));
        some += here;
      },
      large
  );
  return large == 0;
}

/// e^x for |x| <= 0.1 by its power series to x^9: exact to round-off.
KOKKOS_INLINE_FUNCTION double short_exp(double x) {
  return 1.0 +
         x * (1.0 +
              x * (1.0 / 2 +
                   x * (1.0 / 6 +
                        x * (1.0 / 24 +
                             x * (1.0 / 120 +
                                  x * (1.0 / 720 + x * (1.0 / 5040 +
                                                        x * (1.0 / 40320 + x * (1.0 / 362880))))))))
             );
}

/// e^x; with `Short` only for |x| <= 0.1, and then without a branch.
template <bool Short>
KOKKOS_INLINE_FUNCTION double exponential(double x) {
  if constexpr (Short) return short_exp(x);
  return std::abs(x) <= short_series ? short_exp(x) : std::exp(x);
}

/// exp(A) of a plane tensor whose entries are at most 0.1, in closed form: with t = tr A / 2, B = A
/// - t I and z = -det B,
///
///   exp(A) = e^t (C(z) I + S(z) B),   C = cosh sqrt z,   S = sinh sqrt z / sqrt z
///
/// (cosine and sine for z < 0), by their power series in z. det exp(A) = exp(tr A) to round-off,
/// which keeps the volume of a particle after many steps. Without branches, for the compiler to
/// vectorise.
KOKKOS_INLINE_FUNCTION PlaneTensor short_exponential(const PlaneTensor& a) {
  const double t = 0.5 * (a.xx + a.yy);
  const double d = 0.5 * (a.xx - a.yy);
  const double z = d * d + a.xy * a.yx;
  const double c =
      1.0 +
      z * (1.0 / 2 + z * (1.0 / 24 + z * (1.0 / 720 + z * (1.0 / 40320 + z * (1.0 / 3628800)))));
  const double s =
      1.0 + z * (1.0 / 6 +
                 z * (1.0 / 120 + z * (1.0 / 5040 + z * (1.0 / 362880 + z * (1.0 / 39916800)))));
  const double e = short_exp(t);
  return {e * (c + s * d), e * s * a.xy, e * s * a.yx, e * (c - s * d), short_exp(a.zz)};
}

/// The same for any plane tensor.
KOKKOS_INLINE_FUNCTION PlaneTensor exponential(const PlaneTensor& a) {
  const double largest = std::fmax(
      std::fmax(std::abs(a.xx), std::abs(a.yy)),
      std::fmax(std::fmax(std::abs(a.xy), std::abs(a.yx)), std::abs(a.zz))
  );
  if (largest <= short_series) return short_exponential(a);
  const double t = 0.5 * (a.xx + a.yy);
  const double d = 0.5 * (a.xx - a.yy);
  const double z = d * d + a.xy * a.yx;
  const double root = std::sqrt(std::abs(z));
  const double c = z > 0.0 ? std::cosh(root) : std::cos(root);
  const double s = root < 1e-8 ? 1.0 : (z > 0.0 ? std::sinh(root) : std::sin(root)) / root;
  const double e = std::exp(t);
  return {e * (c + s * d), e * s * a.xy, e * s * a.yx, e * (c - s * d), std::exp(a.zz)};
}

/// In-plane product a b, hoop stretches multiplied.
KOKKOS_INLINE_FUNCTION PlaneTensor multiply(const PlaneTensor& a, const PlaneTensor& b) {
  return {
      a.xx * b.xx + a.xy * b.yx,
      a.xx * b.xy + a.xy * b.yy,
      a.yx * b.xx + a.yy * b.yx,
      a.yx * b.xy + a.yy * b.yy,
      a.zz * b.zz};
}

}  // namespace barreno
