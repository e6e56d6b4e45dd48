// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_angle.hpp"
#include "barreno/arenisca/points_return.hpp"

namespace barreno::arenisca {

// Closest point over pressure and Lode angle at once, where the way to it is smooth: most returns.

/// A point of the surface, by the gain of evp and the turn d of the trial state's angle, and what
/// it leaves of the two conditions of the closest point, with derivatives by gain and d:
///
///   f    = (x - x_tr) fc - metric (q_tr cos d - q) dq/dx    consistency within the half-plane
///   miss = Gamma'/Gamma (q - q_tr cos d) + q_tr sin d       no part of the way along the angle
template <class R>
struct TurnedPoint {
  R half_tangent;  ///< of the turn
  R cosine, sine;  ///< of the turn
  R gamma, bend;   ///< at the angle after it
  ReturnEquation<R> e;
  R over;  ///< q_tr cos d - q
  R f_turn, miss, miss_gain, miss_turn;
};

/// @param m     meridian of triaxial compression at the point
/// @param[in,out] at  with gain, x, cap and half_tangent; all of it
template <class R, class Rock>
BARRENO_FUNCTION void close_turned(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const MeridianOf<R>& m,
    TurnedPoint<R>& at
) {
  const R t = at.half_tangent;
  const R inverse = 1.0 / (1.0 + t * t);
  at.cosine = (1.0 - t * t) * inverse;
  at.sine = 2.0 * t * inverse;
  const R c = from.cosine * at.cosine - from.sine * at.sine;
  const R s = from.sine * at.cosine + from.cosine * at.sine;
  const LodeValueOf<R> strength = lode_value(rock.lode, c, s);
  at.gamma = strength.gamma;
  at.bend = strength.slope / strength.gamma;
  at.e.m = scaled_meridian(m, at.gamma);
  TrialOf<R> part = trial;
  part.q = trial.q * at.cosine;
  close_equation(rock, part, none_of<R>(), at.e);
  const R aside = trial.q * at.sine;
  at.over = part.q - at.e.q;
  at.miss = aside - at.bend * at.over;
  at.miss_gain = at.bend * at.e.dq;
  at.miss_turn = part.q + at.bend * (at.bend * at.e.q + aside) -
                 bending_of(rock.lode, c, s, at.bend) * at.over;
  at.f_turn = trial.metric * at.e.m.slope * (aside + at.bend * (at.e.q - at.over));
}

/// Tangents of half the turns that lead to the axes of the octahedral plane.
template <class R>
struct TurnRange {
  R low, high;
};
template <class R>
BARRENO_FUNCTION TurnRange<R> turns_to_axes(const AngleOf<R>& from) {
  constexpr double root_3_4 = 0.86602540378443865;
  const R up_sine = root_3_4 * from.cosine - 0.5 * from.sine;
  const R up_cosine = 0.5 * from.cosine + root_3_4 * from.sine;
  return {-from.sine / (1.0 + from.cosine), up_sine / (1.0 + up_cosine)};
}

template <class R, class Law>
BARRENO_FUNCTION CapOf<R> moved_cap(const Law& rock, CapOf<R> cap, const R& gain) {
  cap.X = cap.X + cap.slope * gain;
  cap.kappa = cap.kappa + rock.surface.CR * cap.slope * gain;
  return cap;
}

/// Newton's method for both conditions, from no turn. A turn does not go beyond an axis: where the
/// surface has an edge there the closest point may lie on it. Ends as solve_return() does: the step
/// that leaves nothing is taken by the derivatives.
/// @param guess gain of evp near the solution; infinity: none
/// @param[out] half_tangent  of the turn to the closest point
/// @param[out] r  the return within the half-plane there
/// @return where it was found; elsewhere both mean nothing
template <class R, class Rock>
BARRENO_FUNCTION MaskOf<R> return_with_turn(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const R& guess,
    R& half_tangent,
    ReturnedOf<R>& r
) {
  constexpr double nothing = 1e-15, small_step = 1e-12, near_tip = 0.3;
  constexpr int max_iterations = 8;
  const ReturnSearch<R> search = search_of(rock, trial, at_trial);
  const GainBracket<R>& bracket = search.bracket;
  const TurnRange<R> range = turns_to_axes(from);
  const R per_size = trial.triple_bulk / (real::abs(trial.x) + trial.q + rock.stress_floor);
  const MaskOf<R> near = (guess > bracket.low) & (guess < bracket.high);
  MaskOf<R> open = outside & (!search.beyond_tip) & (!search.to_vertex) & (trial.q > 0.0);
  MaskOf<R> found = none_of<R>();
  R gain = real::select(near, guess, search.least);
  half_tangent = R{};
  r = {trial.x, trial.q, trial.evp, trial.cap, none_of<R>()};
  R last_length{};
  for (int i = 0; i < max_iterations && real::any(open); ++i) {
    TurnedPoint<R> at;
    at.half_tangent = half_tangent;
    at.e.gain = gain;
    at.e.x = trial.x - trial.triple_bulk * gain;
    at.e.cap = trial.cap;
    const bool at_start = i == 0 && !real::any(open & (gain != 0.0));
    if (!at_start && real::any(search.capped)) at.e.cap = cap_of(rock, R(trial.evp + gain));
    at.e.cap.present = at.e.cap.present & search.capped;
    const MeridianOf<R> m = at_start ? at_trial : meridian_at(rock.surface, at.e.x, at.e.cap);
    close_turned(rock, from, trial, m, at);

    // On an axis, or where the point cannot turn, the gain alone is searched.
    const MaskOf<R> at_low = (half_tangent <= range.low) & (at.miss > 0.0);
    const MaskOf<R> at_high = (half_tangent >= range.high) & (at.miss < 0.0);
    const MaskOf<R> fixed = at_low | at_high | !from.turnable;
    const R f_turn = real::select(fixed, 0.0, at.f_turn);
    const R miss = real::select(fixed, 0.0, at.miss);
    const R miss_gain = real::select(fixed, 0.0, at.miss_gain);
    const R miss_turn = real::select(fixed, 1.0, at.miss_turn);
    const R determinant = at.e.df * miss_turn - f_turn * miss_gain;
    const R inverse = 1.0 / determinant;
    const R dgain = (f_turn * miss - at.e.f * miss_turn) * inverse;
    const R turn = (at.e.f * miss_gain - at.e.df * miss) * inverse;
    const R dtangent = 0.5 * turn * (1.0 + half_tangent * half_tangent);
    const R length = real::abs(dgain) * per_size + real::abs(turn);

    // The least distance, not another stationary one; and not where the equation of the tip, the
    // top of the meridian or closed pores come in.
    const MaskOf<R> off_cap = (at.e.m.cap_squared < near_tip) | !(at.e.m.slope > 0.0);
    const MaskOf<R> regular = (at.e.df < 0.0) & (miss_turn > 0.0) & (determinant < 0.0) &
                              (at.e.q > 0.0) & (at.over >= 0.0) & !(search.compact & off_cap);
    const MaskOf<R> converged =
        (length <= small_step) | (length * length * length <= nothing * last_length * last_length);
    const MaskOf<R> ends = open & regular & converged;
    const R next_gain = gain + dgain, next = half_tangent + dtangent;
    const R next_tangent = smaller_of(larger_of(next, range.low), range.high);
    r.x = real::select(ends, at.e.x - trial.triple_bulk * dgain, r.x);
    r.q = real::select(ends, at.e.q * (1.0 + at.bend * turn) + at.e.dq * dgain, r.q);
    r.evp = real::select(ends, trial.evp + next_gain, r.evp);
    r.cap = select_points<R>(ends, moved_cap(rock, at.e.cap, dgain), r.cap);
    found = found | ends;
    gain = real::select(open, next_gain, gain);
    half_tangent = real::select(open, next_tangent, half_tangent);
    // What a clamped step leaves is not known.
    last_length = real::select(next == next_tangent, length, 0.0);
    open = open & regular & (!converged) & (gain >= bracket.low) & (gain <= bracket.high);
  }
  const MaskOf<R> limited = !search.capped;
  found = found & (gain >= bracket.low) & (gain <= bracket.high) & (r.q > 0.0) &
          !(limited & (r.x >= rock.surface.vertex));
  if (rock.crush.p3 == 0.0) return found;
  return found & !caught_by_cap(rock, trial, MaskOf<R>(found & limited), r);
}

}  // namespace barreno::arenisca
