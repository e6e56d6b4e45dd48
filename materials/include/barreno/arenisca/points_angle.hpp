// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/lode.hpp"
#include "barreno/arenisca/points_pieces.hpp"
#include "barreno/arenisca/points_shear.hpp"

namespace barreno::arenisca {

// Lode angle of one or several points (parts/lode.hpp), and rock whose strength depends on it.

/// A direction of shear: its Lode angle, the strength there, and the direction of larger angles.
template <class R>
struct AngleOf {
  R cosine{}, sine{};              ///< of theta
  R gamma = R{} + 1.0, bend{};     ///< Gamma and Gamma'/Gamma
  DeviatorOf<R> along, across;     ///< of length 1: s over sqrt(J2), and towards larger theta
  MaskOf<R> turnable = R{} > 0.0;  ///< not on an axis of symmetry
};

/// cos theta and sin theta from those of 3 theta, which is in [0, pi]: Newton's method for the cube
/// root of a complex number of modulus 1, from within 4e-5 of it.
template <class R>
BARRENO_FUNCTION void divide_angle_by_3(const R& cosine_3, const R& sine_3, R& cosine, R& sine) {
  constexpr int iterations = 2;
  const R half = real::sqrt(real::larger(R(0.5 + 0.5 * cosine_3), 0.0));  // cos(3 theta/2)
  // (1 - cos theta)/(1 - cos(3 theta/2)) is nearly straight.
  const R ratio =
      0.4999722874 - half * (0.0763556639 - half * (0.0279264050 - half * 0.0071231872));
  const R less = (1.0 - half) * ratio;
  cosine = 1.0 - less;
  sine = real::sqrt(real::larger(R(less * (2.0 - less)), 0.0));
  for (int i = 0; i < iterations; ++i) {
    const R square_re = cosine * cosine - sine * sine, square_im = 2.0 * cosine * sine;
    const R inverse = 1.0 / (square_re * square_re + square_im * square_im);
    const R ratio_re = (cosine_3 * square_re + sine_3 * square_im) * inverse;
    const R ratio_im = (sine_3 * square_re - cosine_3 * square_im) * inverse;
    cosine = (2.0 * cosine + ratio_re) * (1.0 / 3.0);
    sine = (2.0 * sine + ratio_im) * (1.0 / 3.0);
  }
}

/// The matrix product of a symmetric tensor with itself.
template <class R>
BARRENO_FUNCTION Sym3Of<R> square_of(const Sym3Of<R>& n) {
  return {
      n.xx * n.xx + n.xy * n.xy + n.zx * n.zx,
      n.xy * n.xy + n.yy * n.yy + n.yz * n.yz,
      n.zx * n.zx + n.yz * n.yz + n.zz * n.zz,
      n.xx * n.xy + n.xy * n.yy + n.zx * n.yz,
      n.xy * n.zx + n.yy * n.yz + n.yz * n.zz,
      n.xx * n.zx + n.xy * n.yz + n.zx * n.zz};
}

/// cos 3 theta of shear stresses of size q.
template <class R>
BARRENO_FUNCTION R triple_cosine(const DeviatorOf<R>& s, const R& q) {
  const Sym3Of<R>& t = s.tensor;
  const R third = t.xx * (t.yy * t.zz - t.yz * t.yz) - t.xy * (t.xy * t.zz - t.yz * t.zx) +
                  t.zx * (t.xy * t.yz - t.yy * t.zx);
  const R ratio = third / real::select(q > 0.0, q * q * q, 1.0);
  return real::larger(real::smaller(R((1.5 * 1.7320508075688772) * ratio), 1.0), -1.0);
}
/// Gamma of shear stresses of size q.
template <class R>
BARRENO_FUNCTION R strength_at(const Lode& lode, const DeviatorOf<R>& s, const R& q) {
  const R cosine_3 = triple_cosine(s, q);
  if (lode.active() && lode.kind == Lode::gudehus) return 1.0 / gudehus_inverse(lode.psi, cosine_3);
  const R sine_3 = real::sqrt(R((1.0 - cosine_3) * (1.0 + cosine_3)));
  R cosine{}, sine{};
  divide_angle_by_3(cosine_3, sine_3, cosine, sine);
  return lode_value(lode, cosine, sine).gamma;
}

/// Where shear stresses point; the axes' own directions (theta = 0 or pi/3) cannot turn.
template <class R>
BARRENO_FUNCTION AngleOf<R> angle_of(const Lode& lode, const DeviatorOf<R>& s) {
  constexpr double axis = 1e-7, root_3 = 1.7320508075688772;
  const R q = real::sqrt(squared(s));
  const MaskOf<R> sheared = q > 0.0;
  AngleOf<R> a;
  a.along = R(real::select(sheared, 1.0 / q, 0.0)) * s;
  // The deviator of the square is 1/sqrt(3) long and points to -2 theta: towards triaxial
  // extension.
  DeviatorOf<R> side{deviator(square_of(a.along.tensor))};
  side = side - R(dot(side, a.along)) * a.along;
  const R length = real::sqrt(squared(side));
  a.turnable = sheared & (length > axis);
  a.across = R(real::select(a.turnable, -1.0 / length, 0.0)) * side;
  // Near the axes the cosine is flat, and this sine keeps its digits.
  divide_angle_by_3(
      triple_cosine(s, q), R(real::smaller(R(root_3 * length), 1.0)), a.cosine, a.sine
  );
  const LodeValueOf<R> v = lode_value(lode, a.cosine, a.sine);
  a.gamma = v.gamma;
  a.bend = v.slope / v.gamma;
  return a;
}

/// The angle after a turn of which the tangent of the half is given.
template <class R>
struct TurnedAngle {
  R cosine, sine;  ///< of the turn
  LodeValueOf<R> strength;
};
template <class R>
BARRENO_FUNCTION TurnedAngle<R> turned_by(
    const Lode& lode, const AngleOf<R>& from, const R& half_tangent
) {
  const R inverse = 1.0 / (1.0 + half_tangent * half_tangent);
  const R c = (1.0 - half_tangent * half_tangent) * inverse, s = 2.0 * half_tangent * inverse;
  const R cosine = from.cosine * c - from.sine * s, sine = from.sine * c + from.cosine * s;
  return {c, s, lode_value(lode, cosine, sine)};
}

/// Dry or wet rock with overstress, of which pieces can have a strength of their own.
template <class Whole>
struct RatedRock : ScatteredRock<Whole> {
  static constexpr bool rated = true;

  double T1 = 0.0, T2 = 0.0;  ///< overstress: relaxation time T1 |D|^-T2; T1 = 0: none
};
template <class R, class Whole>
struct RockFor<R, RatedRock<Whole>> {
  using type = PiecesOf<R, Whole>;
};

/// The same with the third invariant: all that a card can ask for.
template <class Whole>
struct AngledRock : RatedRock<Whole> {
  static constexpr bool angled = true;

  Lode lode;
};

/// Its pieces.
template <class R, class Whole>
struct AngledPiecesOf : PiecesOf<R, Whole> {
  static constexpr bool angled = true;
  Lode lode;
  double weakest;  ///< least Gamma

  BARRENO_FUNCTION AngledPiecesOf(const AngledRock<Whole>& rock, const R& coherence)
      : PiecesOf<R, Whole>(rock, coherence), lode(rock.lode), weakest(rock.lode.weakest()) {}
};
template <class R, class Whole>
struct RockFor<R, AngledRock<Whole>> {
  using type = AngledPiecesOf<R, Whole>;
};

/// What a prediction holds besides where the strength depends on its angle.
template <class R, bool angled>
struct WithAngle {};
template <class R>
struct WithAngle<R, true> {
  AngleOf<R> angle;
};

/// J2 as the meridian of triaxial compression sees it: over Gamma^2.
template <class R, class Rock>
BARRENO_FUNCTION R scaled_J2(const Rock& rock, const ShearIn<R, Rock>& s) {
  const R J2 = squared(s);
  if constexpr (Rock::angled) {
    const R gamma = strength_at(rock.lode, s, R(real::sqrt(J2)));
    return J2 / (gamma * gamma);
  } else {
    return J2;
  }
}

}  // namespace barreno::arenisca
