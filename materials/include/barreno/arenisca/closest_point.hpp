// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/crush_curve.hpp"
#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/yield_surface.hpp"

namespace barreno::arenisca {

// The flow rule of one point or several (real.hpp): in which metric a return is the closest point,
// the condition of that point, and what rock does whose pores close altogether.

/// Trial state outside the surface, in x = I1 and q = sqrt(J2) at constant Lode angle.
///
/// Returned is the point closest to the trial point in z = I1/sqrt(3), r = beta sqrt(3K/G)
/// sqrt(J2). Three times that distance squared is (x_tr - x)^2 + metric (q_tr - q)^2 with the
/// metric of the flow rule (parts/flow_rule.hpp): 9 beta^2 K/G in the published one.
template <class R>
struct TrialOf {
  R x, q;
  R metric;       ///< of the flow rule
  R triple_bulk;  ///< 3K, so that d(evp) = (x_tr - x)/3K [stress]
  R evp;          ///< volumetric plastic strain at the start of the substep
  CapOf<R> cap;   ///< cap at that evp
};
using Trial = TrialOf<double>;

// The return is one scalar equation, because evp fixes everything: x = x_tr - 3K (evp - evp_n) by
// elasticity, the cap by the crush curve, q = Ff fc by the surface; what is left is that the line
// to the trial point is normal to the surface,
//
//   (x - x_tr) fc = metric (q_tr - Ff fc) A,   A = fc d(Ff fc)/dx.
//
// At the tip fc -> 0 like a square root. Collecting fc and squaring gives, on the compacting side,
//
//   fc^2 = (metric q_tr A / D)^2,   D = (x - x_tr) + metric Ff A,
//
// which is smooth through the tip (hydrostatic crushing is no special case), while the first form
// is smooth where A changes sign. q = q_tr metric Ff A / D is what is left of the trial shear.

/// The first form, left less right, and its derivative.
template <class R>
struct NormalityOf {
  R f, df;
};
/// @param back    x - x_tr
/// @param dx, d, s  derivatives by the unknown, and the shear strength at x
template <class R>
BARRENO_FUNCTION NormalityOf<R> normality(
    const TrialOf<R>& trial,
    const MeridianOf<R>& m,
    const R& back,
    const R& dx,
    const MeridianRateOf<R>& d,
    const ShearStrengthOf<R>& s
) {
  const R over = trial.q - s.q;
  return {
      back * s.fc - trial.metric * over * m.slope,
      dx * s.fc + back * s.dfc - trial.metric * (over * d.slope - s.dq * m.slope)};
}

/// metric q_tr A / D, of which the second form compares the square with fc^2; times Ff it is q.
template <class R>
struct TipRatioOf {
  R whole, inverse;  ///< D and 1/D
  R shear;           ///< metric q_tr
  R value;
};
template <class R>
BARRENO_FUNCTION TipRatioOf<R> tip_ratio(
    const TrialOf<R>& trial, const MeridianOf<R>& m, const R& back
) {
  TipRatioOf<R> t;
  t.whole = back + trial.metric * m.limit * m.slope;
  t.inverse = 1.0 / t.whole;
  t.shear = trial.metric * trial.q;
  t.value = t.shear * m.slope * t.inverse;
  return t;
}
/// Its derivative by the unknown.
template <class R>
BARRENO_FUNCTION R tip_ratio_rate(
    const TrialOf<R>& trial,
    const MeridianOf<R>& m,
    const R& dx,
    const MeridianRateOf<R>& d,
    const TipRatioOf<R>& t
) {
  const R dwhole = dx + trial.metric * (d.limit * m.slope + m.limit * d.slope);
  return (t.shear * d.slope - t.value * dwhole) * t.inverse;
}

/// All pores closed: evp stops at that of closed pores (or where it was, if they were closed
/// before) and the flow is isochoric; what porosity shear would open at this pressure crushes at
/// once, so the shear limit without cap holds.
template <class R>
struct ClosedOf {
  R x, q, evp;
};
template <class R, class Surface>
BARRENO_FUNCTION ClosedOf<R> return_with_closed_pores(
    const Surface& surface, double closed_evp, const TrialOf<R>& trial
) {
  const R evp = real::select(trial.cap.present, closed_evp, trial.evp);
  const R x =
      smaller_of(R(trial.x - trial.triple_bulk * (evp - trial.evp)), R(R{} + surface.vertex));
  const R limit = real::larger(surface.limit_at(x).value, 0.0);
  return {x, smaller_of(trial.q, limit), evp};
}

/// Steps that are tried for enough dilation: from the first a quarter farther each until it has
/// tripled, then twice as far. Where pores are all but closed the cap retracts so fast that it
/// overtakes the dilated point again: the condition then has three roots, the first two close
/// together just beyond the first step. The first is the one that the rock takes.
template <class R>
BARRENO_FUNCTION R next_dilation(const R& step, const R& first) {
  constexpr double near = 3.0, short_way = 1.25, long_way = 2.0;
  return step * real::select(step < near * first, short_way, long_way);
}

}  // namespace barreno::arenisca
