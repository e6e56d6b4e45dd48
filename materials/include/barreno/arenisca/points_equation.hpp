// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/closest_point.hpp"
#include "barreno/arenisca/rock.hpp"

namespace barreno::arenisca {

/// The equation of the return at evp + gain, and the point of the surface there, with derivatives
/// by the gain.
template <class R>
struct ReturnEquation {
  R gain, x;
  CapOf<R> cap{};
  MeridianOf<R> m{};
  R f{}, df{};
  R q{}, dq{};
};

/// Where the form for the tip of the cap is taken (closest_point.hpp).
template <class R>
BARRENO_FUNCTION MaskOf<R> is_at_tip(const MaskOf<R>& compacting, const MeridianOf<R>& m) {
  constexpr double near_tip = 0.3;
  return compacting & (m.cap_squared < near_tip) & (m.slope > 0.0);
}

/// The condition of the closest point (closest_point.hpp) from the meridian; without the cap that
/// is the return to the limit surface. Positive below the solution; on the compacting side the form
/// is taken that is the smoother one.
/// @param compacting where the compacting side is meant
template <class R, class Law>
BARRENO_FUNCTION void close_equation(
    const Law& rock, const TrialOf<R>& trial, const MaskOf<R>& compacting, ReturnEquation<R>& e
) {
  const MeridianOf<R>& m = e.m;
  const R dx = -trial.triple_bulk;
  const MeridianRateOf<R> d = meridian_rate(rock.surface, m, dx, e.cap.slope);
  const R back = e.x - trial.x;
  const ShearStrengthOf<R> s = shear_strength(m, d);
  e.q = s.q;
  e.dq = s.dq;
  const NormalityOf<R> normal = normality(trial, m, back, dx, d, s);
  e.f = normal.f;
  e.df = normal.df;
  if (!real::any(compacting)) return;
  // Past the top of the meridian: enough compaction, by no matter how much.
  const MaskOf<R> past_top = compacting & !(m.slope > 0.0);
  e.f = real::select(past_top, 1.0, e.f);
  e.df = real::select(past_top, 0.0, e.df);
  const MaskOf<R> at_tip = is_at_tip(compacting, m);
  if (!real::any(at_tip)) return;
  const TipRatioOf<R> t = tip_ratio(trial, m, back);
  const R dratio = tip_ratio_rate(trial, m, dx, d, t);
  e.f = real::select(at_tip, m.cap_squared - t.value * t.value, e.f);
  e.df = real::select(at_tip, d.cap_squared - 2.0 * t.value * dratio, e.df);
  // At the solution fc = ratio; towards the tip that form of q is the smooth one.
  e.q = real::select(at_tip, m.limit * t.value, e.q);
  e.dq = real::select(at_tip, d.limit * t.value + m.limit * dratio, e.dq);
}

/// @param capped  where the cap plays a part
template <class R, class Law>
BARRENO_FUNCTION ReturnEquation<R> return_equation(
    const Law& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& capped,
    const MaskOf<R>& compacting,
    const R& gain
) {
  ReturnEquation<R> e{gain, trial.x - trial.triple_bulk * gain};
  if (real::any(capped)) e.cap = cap_of(rock, R(trial.evp + gain));
  e.cap.present = e.cap.present & capped;
  e.m = meridian_at(rock.surface, e.x, e.cap);
  close_equation(rock, trial, compacting, e);
  return e;
}

/// A point that is done keeps its own while others go on.
template <class R>
BARRENO_FUNCTION void advance_points(
    const MaskOf<R>& open, const ReturnEquation<R>& next, ReturnEquation<R>& e
) {
  e.gain = real::select(open, next.gain, e.gain);
  e.x = real::select(open, next.x, e.x);
  assign_where(open, next.cap, e.cap);
  e.f = real::select(open, next.f, e.f);
  e.df = real::select(open, next.df, e.df);
  e.q = real::select(open, next.q, e.q);
  e.dq = real::select(open, next.dq, e.dq);
}

/// Bracket of the gain: f > 0 at `low` and f < 0 at `high`.
template <class R>
struct GainBracket {
  R low, high;
};

/// Newton's method in a bracket; a step that leaves it or does not shrink is replaced by bisection.
///
/// Errors fall as e' = C e^2, and two steps tell C: a step l after a step L leaves l^3/L^2. The
/// step that leaves nothing ends the search, and takes the point of the surface along by its
/// derivatives, without another evaluation.
/// @param open where a root is asked for
/// @param[in,out] e the equation at the first guess; at the root gain, x, q and cap
/// @return where it has not converged
template <class R, class Law>
BARRENO_FUNCTION MaskOf<R> solve_return(
    const Law& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& capped,
    const MaskOf<R>& compacting,
    MaskOf<R> open,
    GainBracket<R> bracket,
    ReturnEquation<R>& e
) {
  constexpr double nothing = 1e-15, small_step = 1e-12;
  constexpr int max_iterations = 40;
  const R size = (real::abs(trial.x) + trial.q + rock.stress_floor) / trial.triple_bulk;
  R last_step = bracket.high - bracket.low;
  R last_newton{};
  R final_step{};
  for (int i = 0; i < max_iterations; ++i) {
    const MaskOf<R> below = e.f > 0.0;
    bracket.low = real::select(below, e.gain, bracket.low);
    bracket.high = real::select(below, bracket.high, e.gain);
    const R width = bracket.high - bracket.low;
    const R step = -e.f / e.df;
    const R length = real::abs(step);
    const R newton = e.gain + step;
    const MaskOf<R> inside = (newton >= bracket.low) & (newton <= bracket.high);
    const MaskOf<R> converged =
        inside & ((length <= small_step * size) |
                  (length * length * length <= nothing * size * last_newton * last_newton));
    const MaskOf<R> exhausted = (e.f == 0.0) | (width <= nothing * (size + real::abs(trial.evp)));
    final_step = real::select(open & converged, step, final_step);
    open = open & !(converged | exhausted);
    if (!real::any(open)) break;
    const MaskOf<R> sound = inside & (length < 0.6 * last_step);
    const R next = real::select(sound, newton, 0.5 * (bracket.low + bracket.high));
    last_step = real::select(sound, length, width);
    last_newton = real::select(sound, length, 0.0);
    advance_points<R>(open, return_equation(rock, trial, capped, compacting, next), e);
  }
  e.gain = e.gain + final_step;
  e.x = e.x - trial.triple_bulk * final_step;
  e.q = e.q + e.dq * final_step;
  e.cap.X = e.cap.X + e.cap.slope * final_step;
  e.cap.kappa = e.cap.kappa + rock.surface.CR * e.cap.slope * final_step;
  return open;
}

}  // namespace barreno::arenisca
