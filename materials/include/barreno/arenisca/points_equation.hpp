// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points.hpp"

namespace barreno::arenisca {

/// Trial states outside the surface, see Trial.
template <class R>
struct TrialOf {
  R x, q;
  R metric;       ///< 9 beta^2 K/G
  R triple_bulk;  ///< 3K [stress]
  R evp;
  CapOf<R> cap;  ///< at that evp
};

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

/// CompactingSide or DilatingSide (return_map.hpp) from the meridian; without the cap the second is
/// the return to the limit surface. Both are positive below the solution, and have the same sign on
/// the compacting side: there the form is taken that is the smoother one.
/// @param compact where the compacting side is meant
template <class R, class Law>
BARRENO_FUNCTION void close_equation(
    const Law& rock, const TrialOf<R>& trial, const MaskOf<R>& compact, ReturnEquation<R>& e
) {
  constexpr double near_tip = 0.3;
  const MeridianOf<R>& m = e.m;
  const R dx = -trial.triple_bulk;
  const R dX = real::select(m.on_cap, e.cap.slope, 0.0);
  const R dlength = (rock.surface.CR - 1.0) * dX;
  const R dc =
      real::select(m.on_cap, (rock.surface.CR * dX - dx - m.c * dlength) * m.inverse_length, 0.0);
  const R dcap_squared = -2.0 * m.c * dc;
  const R dlimit = m.limit_slope * dx;
  const R curvature = -(rock.surface.a2 * rock.surface.a2) * m.curved;
  const R dslope =
      curvature * dx * m.cap_squared + m.limit_slope * dcap_squared +
      (dlimit * m.c + m.limit * (dc - m.c * dlength * m.inverse_length)) * m.inverse_length;
  const R back = e.x - trial.x;
  const R fc = real::sqrt(real::larger(m.cap_squared, 0.0));
  const R dfc = real::select(fc > 0.0, 0.5 * dcap_squared / fc, 0.0);
  e.q = m.limit * fc;
  e.dq = dlimit * fc + m.limit * dfc;
  const R over = trial.q - e.q;
  e.f = back * fc - trial.metric * over * m.slope;
  e.df = dx * fc + back * dfc - trial.metric * (over * dslope - e.dq * m.slope);
  if (!real::any(compact)) return;
  // Past the top of the meridian: enough compaction, by no matter how much.
  const MaskOf<R> past_top = compact & !(m.slope > 0.0);
  e.f = real::select(past_top, 1.0, e.f);
  e.df = real::select(past_top, 0.0, e.df);
  const MaskOf<R> at_tip = compact & (m.cap_squared < near_tip) & (m.slope > 0.0);
  if (!real::any(at_tip)) return;
  const R whole = back + trial.metric * m.limit * m.slope;
  const R dwhole = dx + trial.metric * (dlimit * m.slope + m.limit * dslope);
  const R inverse = 1.0 / whole;
  const R shear = trial.metric * trial.q;
  const R ratio = shear * m.slope * inverse;
  const R dratio = (shear * dslope - ratio * dwhole) * inverse;
  e.f = real::select(at_tip, m.cap_squared - ratio * ratio, e.f);
  e.df = real::select(at_tip, dcap_squared - 2.0 * ratio * dratio, e.df);
  // At the solution fc = ratio; towards the tip that form of q is the smooth one.
  e.q = real::select(at_tip, m.limit * ratio, e.q);
  e.dq = real::select(at_tip, dlimit * ratio + m.limit * dratio, e.dq);
}

/// @param capped  where the cap plays a part
template <class R, class Law>
BARRENO_FUNCTION ReturnEquation<R> return_equation(
    const Law& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& capped,
    const MaskOf<R>& compact,
    const R& gain
) {
  ReturnEquation<R> e{gain, trial.x - trial.triple_bulk * gain};
  if (real::any(capped)) e.cap = cap_of(rock, R(trial.evp + gain));
  e.cap.present = e.cap.present & capped;
  e.m = meridian_at(rock.surface, e.x, e.cap);
  close_equation(rock, trial, compact, e);
  return e;
}

template <class R>
BARRENO_FUNCTION CapOf<R> select_points(
    const MaskOf<R>& choice, const CapOf<R>& yes, const CapOf<R>& no
) {
  return {
      MaskOf<R>((choice & yes.present) | ((!choice) & no.present)),
      real::select(choice, yes.X, no.X),
      real::select(choice, yes.kappa, no.kappa),
      real::select(choice, yes.slope, no.slope)};
}
/// A point that is done keeps its own while others go on.
template <class R>
BARRENO_FUNCTION void advance_points(
    const MaskOf<R>& open, const ReturnEquation<R>& next, ReturnEquation<R>& e
) {
  e.gain = real::select(open, next.gain, e.gain);
  e.x = real::select(open, next.x, e.x);
  e.cap = select_points<R>(open, next.cap, e.cap);
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
    const MaskOf<R>& compact,
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
    advance_points<R>(open, return_equation(rock, trial, capped, compact, next), e);
  }
  e.gain = e.gain + final_step;
  e.x = e.x - trial.triple_bulk * final_step;
  e.q = e.q + e.dq * final_step;
  e.cap.X = e.cap.X + e.cap.slope * final_step;
  e.cap.kappa = e.cap.kappa + rock.surface.CR * e.cap.slope * final_step;
  return open;
}

}  // namespace barreno::arenisca
