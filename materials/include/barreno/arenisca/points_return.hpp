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

/// Where they come back to. `refused` where the answer is left to return_fast(): rare branches.
template <class R>
struct ReturnedOf {
  R x, q, evp;
  CapOf<R> cap;  ///< at the new evp
  MaskOf<R> refused;
};

/// The equation of the return at evp + gain, its derivative by the gain, and what was met on the way.
template <class R>
struct ReturnEquation {
  R gain, x, f{}, df{};
  CapOf<R> cap{};
  MeridianOf<R> m{};
};

/// f and df from the meridian.
template <class R>
BARRENO_FUNCTION void close_equation(
    const Rock& rock, const TrialOf<R>& trial, const MaskOf<R>& compact, ReturnEquation<R>& e
) {
  const MeridianOf<R>& m = e.m;
  const R dx = -trial.triple_bulk;
  const R dX = real::select(m.on_cap, e.cap.slope, 0.0);
  const R dlength = (rock.surface.CR - 1.0) * dX;
  const R dc = real::select(
      m.on_cap, (rock.surface.CR * dX - dx - m.c * dlength) * m.inverse_length, 0.0
  );
  const R dcap_squared = -2.0 * m.c * dc;
  const R dlimit = m.limit_slope * dx;
  const R curvature = -(rock.surface.a2 * rock.surface.a2) * m.curved;
  const R dslope = curvature * dx * m.cap_squared + m.limit_slope * dcap_squared +
                   (dlimit * m.c + m.limit * (dc - m.c * dlength * m.inverse_length)) *
                       m.inverse_length;
  const R back = e.x - trial.x;
  const R fc_squared = real::larger(m.cap_squared, 0.0);
  const R fc = real::sqrt(fc_squared);
  const R dfc = real::select(fc > 0.0, 0.5 * dcap_squared / fc, 0.0);
  const R over = trial.q - m.limit * fc;
  e.f = back * fc - trial.metric * over * m.slope;
  e.df = dx * fc + back * dfc -
         trial.metric * (over * dslope - (dlimit * fc + m.limit * dfc) * m.slope);
  if (!real::any(compact)) return;
  const R whole = back + trial.metric * m.limit * m.slope;
  const R dwhole = dx + trial.metric * (dlimit * m.slope + m.limit * dslope);
  const MaskOf<R> rising = m.slope > 0.0;
  const R inverse = 1.0 / real::select(rising, whole, 1.0);
  const R ratio = real::select(rising, trial.metric * trial.q * m.slope * inverse, 0.0);
  const R dratio =
      real::select(rising, (trial.metric * trial.q * dslope - ratio * dwhole) * inverse, 0.0);
  e.f = real::select(compact, m.cap_squared - ratio * ratio, e.f);
  e.df = real::select(compact, dcap_squared - 2.0 * ratio * dratio, e.df);
}

/// CompactingSide or DilatingSide (return_map.hpp) and their derivatives, by one pass over the
/// meridian; without the cap the second is the return to the limit surface. Both are positive below
/// the solution.
/// @param capped  where the cap plays a part
/// @param compact where the compacting side is meant
template <class R>
BARRENO_FUNCTION ReturnEquation<R> return_equation(
    const Rock& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& capped,
    const MaskOf<R>& compact,
    const R& gain
) {
  ReturnEquation<R> e{gain, trial.x - trial.triple_bulk * gain};
  e.cap = CapOf<R>{none_of<R>()};
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
/// What a solution needs of the equation; a point that is done keeps its own while others go on.
template <class R>
BARRENO_FUNCTION void advance_points(
    const MaskOf<R>& open, const ReturnEquation<R>& next, ReturnEquation<R>& e
) {
  e.gain = real::select(open, next.gain, e.gain);
  e.x = real::select(open, next.x, e.x);
  e.f = real::select(open, next.f, e.f);
  e.df = real::select(open, next.df, e.df);
  e.cap = select_points<R>(open, next.cap, e.cap);
  e.m.limit = real::select(open, next.m.limit, e.m.limit);
  e.m.cap_squared = real::select(open, next.m.cap_squared, e.m.cap_squared);
  e.m.slope = real::select(open, next.m.slope, e.m.slope);
}

/// Bracket of the gain: f > 0 at `low` and f < 0 at `high`.
template <class R>
struct GainBracket {
  R low, high;
};

/// Newton's method in a bracket; a step that leaves it or does not shrink is replaced by bisection.
/// @param open where a root is asked for
/// @param[in,out] e the equation at the first guess, and at the root
/// @return where it has not converged
template <class R>
BARRENO_FUNCTION MaskOf<R> solve_return(
    const Rock& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& capped,
    const MaskOf<R>& compact,
    MaskOf<R> open,
    GainBracket<R> bracket,
    ReturnEquation<R>& e
) {
  // The last step is smaller than this and is left out: three digits beyond the 1e-9 to which the
  // solvers agree.
  constexpr double accuracy = 1e-12, round_off = 1e-15;
  constexpr int most_iterations = 30;
  const R tolerance =
      (accuracy * (real::abs(trial.x) + trial.q + rock.stress_floor)) / trial.triple_bulk;
  R last_step = bracket.high - bracket.low;
  for (int i = 0; i < most_iterations; ++i) {
    const MaskOf<R> below = e.f > 0.0;
    bracket.low = real::select(below, e.gain, bracket.low);
    bracket.high = real::select(below, bracket.high, e.gain);
    const R width = bracket.high - bracket.low;
    const R step = -e.f / e.df;
    const R size = real::abs(step);
    const R enough = tolerance + round_off * real::abs(R(trial.evp + e.gain));
    open = open & !((size <= enough) | (e.f == 0.0) | (width <= enough));
    if (!real::any(open)) break;
    const R newton = e.gain + step;
    const MaskOf<R> sound =
        (newton > bracket.low) & (newton < bracket.high) & (size < 0.6 * last_step);
    const R next = real::select(sound, newton, 0.5 * (bracket.low + bracket.high));
    last_step = real::select(sound, size, width);
    advance_points<R>(open, return_equation(rock, trial, capped, compact, next), e);
  }
  return open;
}

/// Stress at a solved gain, see point_on_cap().
template <class R>
BARRENO_FUNCTION ReturnedOf<R> returned_at(
    const TrialOf<R>& trial, const ReturnEquation<R>& e, const MaskOf<R>& refused
) {
  constexpr double near_tip = 0.1;
  const MeridianOf<R>& m = e.m;
  const R kept = trial.metric * m.limit * m.slope;
  const MaskOf<R> at_tip = (m.cap_squared < near_tip) & (m.slope > 0.0);
  const R whole = real::select(at_tip, (e.x - trial.x) + kept, 1.0);
  const R limit = m.limit * real::sqrt(real::larger(m.cap_squared, 0.0));
  const R q = real::larger(R(real::select(at_tip, trial.q * kept / whole, limit)), 0.0);
  return {e.x, smaller_of(q, trial.q), trial.evp + e.gain, e.cap, refused};
}

/// Where a return to the limit surface or the vertex finds that the cap has retracted into the way:
/// return to that cap.
/// @param limited where the return went to the limit surface or the vertex
template <class R>
BARRENO_FUNCTION void return_to_retracted_cap(
    const Rock& rock, const TrialOf<R>& trial, const MaskOf<R>& limited, ReturnedOf<R>& r
) {
  const double last_open = rock.crush.last_open();
  CapOf<R> end = cap_of(rock, R(real::larger(r.evp, last_open)));
  const MaskOf<R> caught = limited & (r.x < end.kappa);
  end.present = r.evp > last_open;
  r.cap = select_points<R>(limited, end, r.cap);
  if (!real::any(caught)) return;
  const MaskOf<R> compact = none_of<R>();
  ReturnEquation<R> e = return_equation(rock, trial, caught, compact, R(r.evp - trial.evp));
  const R farthest = (trial.x - trial.cap.X) / trial.triple_bulk;
  const MaskOf<R> failed =
      solve_return(rock, trial, caught, compact, caught, GainBracket<R>{R{}, farthest}, e);
  const ReturnedOf<R> onto = returned_at(trial, e, failed | (caught & !trial.cap.present));
  r.x = real::select(caught, onto.x, r.x);
  r.q = real::select(caught, onto.q, r.q);
  r.evp = real::select(caught, onto.evp, r.evp);
  r.cap = select_points<R>(caught, onto.cap, r.cap);
  r.refused = r.refused | (caught & onto.refused);
}

/// return_fast() where it takes its common branches: compaction, retracting cap, limit surface,
/// vertex.
/// @param outside  where a return is asked for
/// @param at_trial the meridian at the trial state
/// @param guess    gain of evp near the solution, as of a return nearby; NaN: none
template <class R>
BARRENO_FUNCTION ReturnedOf<R> return_points(
    const Rock& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const R& guess
) {
  const YieldSurface& surface = rock.surface;
  const R per_bulk = 1.0 / trial.triple_bulk;
  const MaskOf<R> capped = trial.cap.present & (trial.x < trial.cap.kappa);
  const MaskOf<R> compact = capped & ((trial.x <= trial.cap.X) | (at_trial.slope > 0.0));
  const R reach = trial.metric * trial.q * surface.steepest;
  const MaskOf<R> to_vertex = (!capped) & (trial.x - surface.vertex >= reach);

  // Bracket: at x = kappa_n the hardened cap's branch point is passed; at x = X there is always
  // enough dilation; the limit surface is nowhere steeper than at its vertex.
  const R last_open = rock.crush.last_open() - trial.evp;
  const R to_kappa = (trial.x - trial.cap.kappa) * per_bulk;
  const R to_X = (trial.x - trial.cap.X) * per_bulk;
  const MaskOf<R> beyond_vertex = (!capped) & (trial.x > surface.vertex);
  const R least = real::select(beyond_vertex, (trial.x - surface.vertex) * per_bulk, 0.0);
  const GainBracket<R> bracket = {
      real::select(compact, larger_of(to_kappa, last_open), least),
      real::select(compact, 0.0, real::select(capped, to_X, reach * per_bulk))};

  ReturnEquation<R> e{R{}, trial.x, R{}, R{}, trial.cap, at_trial};
  e.cap.present = capped;
  close_equation(rock, trial, compact, e);
  const MaskOf<R> guessed = (guess > bracket.low) & (guess < bracket.high);
  const MaskOf<R> wanted = outside & !to_vertex;
  const MaskOf<R> elsewhere = wanted & (guessed | beyond_vertex);
  // A trial state that is past its own solution stays where it is.
  const MaskOf<R> at_once = (!elsewhere) & ((e.f == 0.0) | ((e.f > 0.0) == compact));
  if (real::any(elsewhere)) {
    const R start = real::select(guessed, guess, least);
    advance_points<R>(elsewhere, return_equation(rock, trial, capped, compact, start), e);
  }
  MaskOf<R> refused =
      solve_return(rock, trial, capped, compact, MaskOf<R>(wanted & !at_once), bracket, e);
  // Pores that close altogether.
  refused = refused | (wanted & compact & (e.gain <= last_open + 1e-6 * rock.crush.p3));
  ReturnedOf<R> r = returned_at(trial, e, refused);
  r.x = real::select(to_vertex, surface.vertex, r.x);
  r.q = real::select(to_vertex, 0.0, r.q);
  r.evp = real::select(to_vertex, trial.evp + least, r.evp);
  if (rock.crush.p3 > 0.0)
    return_to_retracted_cap(rock, trial, MaskOf<R>(outside & !capped), r);
  return r;
}

}  // namespace barreno::arenisca
