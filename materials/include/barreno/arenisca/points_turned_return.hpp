// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_angle.hpp"
#include "barreno/arenisca/points_return.hpp"

namespace barreno::arenisca {

// Closest point over pressure and Lode angle at once, by Newton's method. Few returns do not get
// there; they are left to the search turn by turn (points_over_angles.hpp).

/// A point of the surface, by the gain of evp and the turn d of the trial state's angle, and what
/// it leaves of the two conditions of the closest point, with derivatives by gain and d:
///
///   f    = (x - x_tr) fc - metric (q_tr cos d - q) dq/dx    consistency within the half-plane
///   residual = Gamma'/Gamma (q - q_tr cos d) + q_tr sin d       no part of the way along the angle
///
/// f near the tip of the cap is the other form of closest_point.hpp.
template <class R>
struct TurnedPoint {
  R half_tangent;  ///< of the turn
  R cosine, sine;  ///< of the turn
  R bend;          ///< Gamma'/Gamma after it
  ReturnEquation<R> e;
  R over;                  ///< q_tr cos d - q
  R f_by_turn, q_by_turn;  ///< derivatives of f and q by d
  R residual, residual_by_gain, residual_by_turn;
};

/// The meridian of triaxial compression at a gain of evp.
template <class R, class Rock>
BARRENO_FUNCTION ReturnEquation<R> compression_at(
    const Rock& rock, const TrialOf<R>& trial, const MaskOf<R>& capped, const R& gain
) {
  ReturnEquation<R> e{gain, trial.x - trial.triple_bulk * gain};
  if (real::any(capped)) e.cap = cap_of(rock, R(trial.evp + gain));
  e.cap.present = e.cap.present & capped;
  e.m = meridian_at(rock.surface, e.x, e.cap);
  return e;
}

/// Derivatives of f and q by the turn.
/// @param part   the trial state within the half-plane
/// @param aside  q_tr sin d
template <class R>
BARRENO_FUNCTION void differentiate_by_turn(
    const TrialOf<R>& part, const MaskOf<R>& compacting, const R& aside, TurnedPoint<R>& at
) {
  const MeridianOf<R>& m = at.e.m;
  const R by_turn = at.bend * at.e.q;
  at.q_by_turn = by_turn;
  at.f_by_turn = part.metric * m.slope * (aside + at.bend * (at.e.q - at.over));
  const MaskOf<R> at_tip = is_at_tip(compacting, m);
  if (!real::any(at_tip)) return;
  const TipRatioOf<R> t = tip_ratio(part, m, R(at.e.x - part.x));
  const R stiff = part.metric * m.limit * m.slope * t.inverse;
  const R ratio_by_turn = t.value * (at.bend * (1.0 - 2.0 * stiff) - aside / part.q);
  at.f_by_turn = real::select(at_tip, -2.0 * t.value * ratio_by_turn, at.f_by_turn);
  at.q_by_turn = real::select(at_tip, by_turn + m.limit * ratio_by_turn, at.q_by_turn);
}

/// @param[in,out] at  with gain, x, cap, the meridian of triaxial compression and half_tangent; all
/// of it
template <class R, class Rock>
BARRENO_FUNCTION void close_turned(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const MaskOf<R>& compacting,
    TurnedPoint<R>& at
) {
  const R t = at.half_tangent;
  const R inverse = 1.0 / (1.0 + t * t);
  at.cosine = (1.0 - t * t) * inverse;
  at.sine = 2.0 * t * inverse;
  const R c = from.cosine * at.cosine - from.sine * at.sine;
  const R s = from.sine * at.cosine + from.cosine * at.sine;
  const LodeBendOf<R> strength = lode_bend(rock.lode, c, s);
  at.bend = strength.bend;
  at.e.m = scaled_meridian(at.e.m, strength.gamma);
  TrialOf<R> part = trial;
  part.q = trial.q * at.cosine;
  close_equation(rock, part, compacting, at.e);
  const R aside = trial.q * at.sine;
  at.over = part.q - at.e.q;
  differentiate_by_turn(part, compacting, aside, at);
  at.residual = aside - at.bend * at.over;
  at.residual_by_gain = at.bend * at.e.dq;
  at.residual_by_turn = part.q + at.bend * (at.q_by_turn + aside) - strength.bend_slope * at.over;
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

/// Where a search ends: relative to stress and turn, a step that is small and what may be left; or
/// a step that is this part of the one before.
struct TurnAccuracy {
  double small_step, nothing, part;
};
/// Of a return that a second one follows, and of the last one. What they leave falls with the
/// increment at least as fast as the step's own error, so that its order and its tangent remain.
constexpr TurnAccuracy rough_turn{1e-7, 1e-12, 0.05}, exact_turn{1e-7, 1e-12, 0.0};
/// Where the slope of the crush curve is not exact, so that steps fall in proportion.
constexpr TurnAccuracy patient_turn{1e-13, 1e-24, 0.0};

/// Which closest point is searched, and from where.
template <class R>
struct TurnSearch {
  MaskOf<R> open;                ///< where it is searched
  MaskOf<R> capped, compacting;  ///< see return_equation()
  MaskOf<R> fixed_gain;          ///< where the gain is given, and the turn alone is searched
  GainBracket<R> bracket;
  TurnAccuracy accuracy;
  R half_tangent;
  ReturnEquation<R> e;  ///< gain and meridian of triaxial compression to begin with
};
/// What was found of it.
template <class R>
struct TurnedReturn {
  MaskOf<R> found;
  R half_tangent;  ///< of the turn
  ReturnedOf<R> point;
};

/// A step of the search.
template <class R>
struct TurnStep {
  R gain, turn;
  MaskOf<R> regular;  ///< by Newton's method, towards a least distance
};
/// Newton's method for both conditions. On an axis, where the surface may have an edge, and where
/// the point cannot turn, the gain alone is searched.
template <class R>
BARRENO_FUNCTION TurnStep<R> newton_step(
    const TurnSearch<R>& search,
    const TurnRange<R>& range,
    const AngleOf<R>& from,
    const TurnedPoint<R>& at
) {
  const MaskOf<R> at_low = (at.half_tangent <= range.low) & (at.residual > 0.0);
  const MaskOf<R> at_high = (at.half_tangent >= range.high) & (at.residual < 0.0);
  const MaskOf<R> fixed = at_low | at_high | !from.turnable;
  const MaskOf<R> coupled = !(fixed | search.fixed_gain);
  const R f = real::select(search.fixed_gain, 0.0, at.e.f);
  const R df = real::select(search.fixed_gain, -1.0, at.e.df);
  const R f_by_turn = real::select(coupled, at.f_by_turn, 0.0);
  const R residual = real::select(fixed, 0.0, at.residual);
  const R residual_by_gain = real::select(coupled, at.residual_by_gain, 0.0);
  const R residual_by_turn = real::select(fixed, 1.0, at.residual_by_turn);
  const R determinant = df * residual_by_turn - f_by_turn * residual_by_gain;
  const R inverse = 1.0 / determinant;
  return {
      (f_by_turn * residual - f * residual_by_turn) * inverse,
      (f * residual_by_gain - df * residual) * inverse,
      (df < 0.0) & (residual_by_turn > 0.0) & (determinant < 0.0)};
}
/// Where that leads elsewhere: half way to the end of the bracket on the side of the solution, and
/// a turn with a slope that is positive for sure.
/// @param irregular  where it is asked for
/// @param[in,out] bracket  between such places
template <class R>
BARRENO_FUNCTION void go_safely(
    const AngleOf<R>& from,
    const MaskOf<R>& irregular,
    const TurnedPoint<R>& at,
    GainBracket<R>& bracket,
    TurnStep<R>& step
) {
  const MaskOf<R> below = at.e.f > 0.0;
  bracket.low = real::select(irregular & below, at.e.gain, bracket.low);
  bracket.high = real::select(irregular & !below, at.e.gain, bracket.high);
  const R end = real::select(below, bracket.high, bracket.low);
  const R size = at.over + at.e.q * (1.0 + at.bend * at.bend);
  const MaskOf<R> turns = from.turnable & (size > 0.0);
  const R turn = real::select(turns, -at.residual / real::select(turns, size, 1.0), 0.0);
  step.gain = real::select(irregular, 0.5 * (end - at.e.gain), step.gain);
  step.turn = real::select(irregular, turn, step.turn);
  step.regular = step.regular & !irregular;
}

/// The return that a last step by the derivatives leads to.
template <class R, class Rock>
BARRENO_FUNCTION ReturnedOf<R> returned_by(
    const Rock& rock, const TrialOf<R>& trial, const TurnedPoint<R>& at, const TurnStep<R>& step
) {
  CapOf<R> cap = at.e.cap;
  cap.X = cap.X + cap.slope * step.gain;
  cap.kappa = cap.kappa + rock.surface.CR * cap.slope * step.gain;
  return {
      at.e.x - trial.triple_bulk * step.gain,
      at.e.q + at.e.dq * step.gain + at.q_by_turn * step.turn,
      trial.evp + at.e.gain + step.gain,
      cap,
      none_of<R>()};
}

/// A gain in its bracket; half way to the end of it where the step leads out.
template <class R>
BARRENO_FUNCTION R within(const GainBracket<R>& bracket, const R& gain, const R& next) {
  const R low = real::select(next < bracket.low, 0.5 * (gain + bracket.low), next);
  return real::select(next > bracket.high, 0.5 * (gain + bracket.high), low);
}

/// Both conditions at once. A turn does not go beyond an axis. The step that leaves nothing is
/// taken by the derivatives, as in solve_return().
/// @param[in,out] r  replaced where it was found
template <class R, class Rock>
BARRENO_FUNCTION void solve_turned(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const TurnSearch<R>& search,
    TurnedReturn<R>& r
) {
  const double nothing = search.accuracy.nothing, small_step = search.accuracy.small_step;
  constexpr int max_iterations = 20;
  const TurnRange<R> range = turns_to_axes(from);
  const R per_size = trial.triple_bulk / (real::abs(trial.x) + trial.q + rock.stress_floor);
  MaskOf<R> open = search.open;
  GainBracket<R> between = search.bracket;
  TurnedPoint<R> at;
  at.half_tangent = search.half_tangent;
  at.e = search.e;
  R last_length{};
  for (int i = 0; i < max_iterations; ++i) {
    close_turned(rock, from, trial, search.compacting, at);
    TurnStep<R> step = newton_step(search, range, from, at);
    // Past the top of the meridian there is too much compaction, by no matter how much.
    const MaskOf<R> past_top = search.compacting & !(at.e.m.slope > 0.0);
    const MaskOf<R> irregular = open & (past_top | !step.regular);
    if (real::any(irregular)) go_safely(from, irregular, at, between, step);
    const R length = real::abs(step.gain) * per_size + real::abs(step.turn);
    const MaskOf<R> converged = (length <= small_step) |
                                (length <= search.accuracy.part * last_length) |
                                (length * length * length <= nothing * last_length * last_length);
    const MaskOf<R> ends = open & step.regular & converged;
    const R next = at.half_tangent + 0.5 * step.turn * (1.0 + at.half_tangent * at.half_tangent);
    const R kept = smaller_of(larger_of(next, range.low), range.high);
    if (real::any(ends)) {
      assign_where(ends, returned_by(rock, trial, at, step), r.point);
      r.half_tangent = real::select(ends, kept, r.half_tangent);
      r.found = r.found | (ends & (at.e.q > 0.0) & (at.over >= 0.0));
      open = open & !ends;
      if (!real::any(open)) return;
    }
    at.half_tangent = kept;
    const R gain = within(search.bracket, at.e.gain, R(at.e.gain + step.gain));
    // What a step leaves that was cut, or is not Newton's, is not known.
    last_length = real::select(step.regular & (next == kept), length, 0.0);
    at.e = compression_at(rock, trial, search.capped, gain);
  }
}

/// What is known of a return beforehand.
template <class R>
struct TurnGuess {
  R gain;          ///< of evp; infinity: nothing is known
  R half_tangent;  ///< of the turn
  bool known;      ///< whether any of both is
  TurnAccuracy accuracy;
};

/// Where the strength is a straight line in the octahedral plane, the turn to its closest point at
/// the trial state's pressure; axes are in the way where the surface has edges.
/// @param strength  of triaxial compression at that pressure [stress]
template <class R>
BARRENO_FUNCTION R
turn_to_line(const Lode& lode, const AngleOf<R>& from, const R& q, const R& strength) {
  const LodeLine line = line_of(lode);
  // The line's foot, seen from the trial state.
  const R cosine = line.cosine * from.cosine + line.sine * from.sine;
  const R sine = line.sine * from.cosine - line.cosine * from.sine;
  const R foot = smaller_of(R(line.foot * strength), R(q * cosine));
  const R along = foot * cosine + q * sine * sine;
  const R across = sine * (foot - q * cosine);
  const R size = along + real::sqrt(R(along * along + across * across));
  const MaskOf<R> ahead = size > 0.0;
  const R half_tangent = real::select(ahead, across / real::select(ahead, size, 1.0), 0.0);
  const TurnRange<R> range = turns_to_axes(from);
  return smaller_of(larger_of(half_tangent, range.low), range.high);
}

/// The search of a return to the cap or to the limit surface.
template <class R, class Rock>
BARRENO_FUNCTION TurnSearch<R> first_search(
    const Rock& rock,
    const TrialOf<R>& trial,
    const ReturnSearch<R>& sides,
    const MaskOf<R>& open,
    const MeridianOf<R>& at_trial,
    const TurnGuess<R>& guess
) {
  TurnSearch<R> search;
  search.open = open;
  // Dilation retracts the cap, maybe into the way: the equation with the cap holds on either side.
  search.capped = trial.cap.present;
  search.compacting = sides.compacting;
  search.fixed_gain = none_of<R>();
  search.bracket = sides.bracket;
  search.accuracy = guess.accuracy;
  search.half_tangent = guess.half_tangent;
  const R start = start_of_return(trial, sides, guess.gain);
  const MaskOf<R> elsewhere = open & (start != 0.0);
  search.e = {R{}, trial.x, trial.cap, at_trial};
  search.e.cap.present = search.capped;
  if (!real::any(elsewhere)) return search;
  const ReturnEquation<R> there = compression_at(rock, trial, search.capped, start);
  search.e.gain = real::select(elsewhere, there.gain, search.e.gain);
  search.e.x = real::select(elsewhere, there.x, search.e.x);
  assign_where(elsewhere, there.cap, search.e.cap);
  assign_where(elsewhere, there.m, search.e.m);
  return search;
}

/// Pores that close altogether, or stay closed: pressure is given, and the turn alone is searched.
/// @param asked  where it may be so
template <class R, class Rock>
BARRENO_FUNCTION void return_closed(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const MaskOf<R>& asked,
    const TurnAccuracy& accuracy,
    TurnedReturn<R>& r
) {
  const MaskOf<R> none = none_of<R>();
  const MaskOf<R> closes = trial.cap.present;
  const R gain = real::select(closes, rock.crush.closed() - trial.evp, 0.0);
  TurnSearch<R> search;
  search.open = search.fixed_gain = asked;
  search.accuracy = accuracy;
  search.capped = search.compacting = none;
  search.bracket = {gain, gain};
  search.half_tangent = r.half_tangent;
  search.e = compression_at(rock, trial, none, gain);
  r.found = r.found & !asked;
  solve_turned(rock, from, trial, search, r);
}

/// Pores are closed where even the smallest ones are too many, see return_points().
/// @param found  closed so far
/// @param[in,out] r  not found where pores open
template <class R, class Rock>
BARRENO_FUNCTION void keep_closed(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const ReturnSearch<R>& sides,
    const MaskOf<R>& found,
    TurnedReturn<R>& r
) {
  TurnedPoint<R> at;
  at.half_tangent = r.half_tangent;
  const R least =
      real::select(trial.cap.present, sides.last_open, real::larger(sides.last_open, 0.0));
  at.e = compression_at(rock, trial, found, least);
  close_turned(rock, from, trial, sides.compacting, at);
  r.found = r.found & !(found & (at.e.f > 0.0));
}

/// Closed pores that stay so, to be seen without a return: whatever dilation opens, the cap's
/// branch point is nearer than the trial state.
template <class R, class Rock>
BARRENO_FUNCTION MaskOf<R> stays_closed_throughout(const Rock& rock, const TrialOf<R>& trial) {
  if (!rock.crush.porous()) return none_of<R>();
  const MaskOf<R> closed = (!trial.cap.present) & (trial.evp <= rock.crush.last_open());
  if (!real::any(closed)) return closed;
  return closed & (trial.x < cap_of(rock, R(R{} + rock.crush.last_open())).kappa);
}

/// The return over the Lode angle, where Newton's method finds it.
/// @param at_trial the meridian of triaxial compression at the trial state
template <class R, class Rock>
BARRENO_FUNCTION TurnedReturn<R> return_with_turn(
    const Rock& rock,
    const AngleOf<R>& from,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const TurnGuess<R>& guess
) {
  ReturnSearch<R> sides = search_of(rock, trial, at_trial);
  // The surface is as steep as it is strong.
  sides.to_vertex = (!sides.capped) & (trial.x - rock.surface.vertex >= from.gamma * sides.reach);
  const R highest = rock.lode.strongest() * sides.bracket.high;
  sides.bracket.high = real::select(sides.capped, sides.bracket.high, highest);
  TurnedReturn<R> r{none_of<R>(), R{}, {trial.x, trial.q, trial.evp, trial.cap, none_of<R>()}};
  const MaskOf<R> open = outside & (!sides.to_vertex) & (trial.q > 0.0);
  const MaskOf<R> never_opened = open & stays_closed_throughout(rock, trial);
  if (real::any(open)) {
    TurnSearch<R> search = first_search(rock, trial, sides, open, at_trial, guess);
    if (rock.lode.kind == Lode::mohr_coulomb && !guess.known) {
      const R factor = real::sqrt(real::larger(at_trial.cap_squared, 0.0));
      const R turn =
          turn_to_line(rock.lode, from, trial.q, real::larger(R(at_trial.limit * factor), 0.0));
      search.half_tangent = real::select(from.turnable, turn, 0.0);
    }
    search.fixed_gain = never_opened;
    search.e.gain = real::select(never_opened, 0.0, search.e.gain);
    solve_turned(rock, from, trial, search, r);
  }
  const MaskOf<R> limited = open & !sides.capped;
  r.found = r.found & (r.point.q > 0.0) & !(limited & (r.point.x >= rock.surface.vertex));
  const MaskOf<R> to_vertex = outside & sides.to_vertex;
  r.point.x = real::select(to_vertex, R(R{} + rock.surface.vertex), r.point.x);
  r.point.q = real::select(to_vertex, 0.0, r.point.q);
  r.point.evp = real::select(to_vertex, trial.evp + sides.least, r.point.evp);
  r.found = r.found | to_vertex;
  if (!rock.crush.porous()) return r;
  const MaskOf<R> limited_and_closed = r.found & !(sides.capped | trial.cap.present | never_opened);
  const MaskOf<R> caught = caught_by_cap(rock, trial, limited_and_closed, r.point);
  const MaskOf<R> stays_closed = caught & !to_vertex;
  const MaskOf<R> closes =
      open & sides.compacting & (!r.found) & (sides.to_kappa < sides.last_open);
  const MaskOf<R> closed = stays_closed | closes;
  if (real::any(closed)) return_closed(rock, from, trial, closed, guess.accuracy, r);
  const MaskOf<R> doubtful = r.found & (closed | never_opened);
  if (real::any(doubtful)) keep_closed(rock, from, trial, sides, doubtful, r);
  const MaskOf<R> vertex_caught = caught_by_cap(rock, trial, to_vertex, r.point);
  r.found = r.found & !vertex_caught;
  return r;
}

}  // namespace barreno::arenisca
