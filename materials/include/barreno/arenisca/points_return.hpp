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
  CapOf<R> cap;  ///< at the new evp, where the return met it
  MaskOf<R> refused;
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
template <class R>
BARRENO_FUNCTION void close_equation(
    const Rock& rock, const TrialOf<R>& trial, const MaskOf<R>& compact, ReturnEquation<R>& e
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
template <class R>
BARRENO_FUNCTION ReturnEquation<R> return_equation(
    const Rock& rock,
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
/// Errors fall as e' = C e^2, and two steps tell C: a step l after a step L leaves l^3/L^2. The step
/// that leaves nothing ends the search, and takes the point of the surface along by its derivatives,
/// without another evaluation.
/// @param open where a root is asked for
/// @param[in,out] e the equation at the first guess; at the root gain, x, q and cap
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
  constexpr double nothing = 1e-15, small_step = 1e-12;
  constexpr int most_iterations = 40;
  const R size = (real::abs(trial.x) + trial.q + rock.stress_floor) / trial.triple_bulk;
  R last_step = bracket.high - bracket.low;
  R last_newton{};
  R final_step{};
  for (int i = 0; i < most_iterations; ++i) {
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
    const MaskOf<R> exhausted =
        (e.f == 0.0) | (width <= nothing * (size + real::abs(trial.evp)));
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

template <class R>
BARRENO_FUNCTION ReturnedOf<R> returned_at(
    const TrialOf<R>& trial, const ReturnEquation<R>& e, const MaskOf<R>& refused
) {
  const R q = real::larger(e.q, 0.0);
  return {e.x, smaller_of(q, trial.q), trial.evp + e.gain, e.cap, refused};
}

/// return_with_closed_pores(), where `closed`.
template <class R>
BARRENO_FUNCTION void close_pores(
    const Rock& rock, const TrialOf<R>& trial, const MaskOf<R>& closed, ReturnedOf<R>& r
) {
  if (!real::any(closed)) return;
  const R evp = real::select(trial.cap.present, -rock.crush.p3, trial.evp);
  const R x =
      real::smaller(R(trial.x - trial.triple_bulk * (evp - trial.evp)), rock.surface.vertex);
  const R limit = real::larger(meridian_at(rock.surface, x, CapOf<R>{}).limit, 0.0);
  r.x = real::select(closed, x, r.x);
  r.q = real::select(closed, smaller_of(trial.q, limit), r.q);
  r.evp = real::select(closed, evp, r.evp);
  r.cap.present = r.cap.present & !closed;
  r.refused = r.refused & !closed;
}

/// Where a return to the limit surface or the vertex finds that the cap has retracted into the way:
/// return to that cap.
/// @param limited where the return went to the limit surface or the vertex
template <class R>
BARRENO_FUNCTION void return_to_retracted_cap(
    const Rock& rock, const TrialOf<R>& trial, const MaskOf<R>& limited, ReturnedOf<R>& r
) {
  // The crush curve is concave: its tangent tells most that clear the cap.
  const double last_open = rock.crush.last_open();
  const R bound = trial.cap.kappa + rock.surface.CR * trial.cap.slope * (r.evp - trial.evp);
  const MaskOf<R> unclear = limited & !(trial.cap.present & (r.x >= bound));
  if (!real::any(unclear)) return;
  const CapOf<R> end = cap_of(rock, R(real::larger(r.evp, last_open)));
  const MaskOf<R> caught = unclear & (r.x < end.kappa);
  if (!real::any(caught)) return;
  // First guess: where the cap's branch point meets the elastic path; closed pores begin to open.
  const R to_branch =
      (trial.x - trial.cap.kappa) / (trial.triple_bulk + rock.surface.CR * trial.cap.slope);
  const R least = real::larger(R(last_open - trial.evp), 0.0);
  const R start = real::select(trial.cap.present, to_branch, least);
  const MaskOf<R> compact = none_of<R>();
  ReturnEquation<R> e = return_equation(rock, trial, caught, compact, start);
  const MaskOf<R> opening = caught & !trial.cap.present;
  const MaskOf<R> closed = opening & (e.f <= 0.0);
  const MaskOf<R> open = caught & !opening;
  const GainBracket<R> bracket{R{}, (trial.x - trial.cap.X) / trial.triple_bulk};
  const MaskOf<R> failed = solve_return(rock, trial, caught, compact, open, bracket, e);
  const ReturnedOf<R> onto = returned_at(trial, e, failed);
  r.x = real::select(open, onto.x, r.x);
  r.q = real::select(open, onto.q, r.q);
  r.evp = real::select(open, onto.evp, r.evp);
  r.cap = select_points<R>(open, onto.cap, r.cap);
  r.refused = r.refused | failed | opening;
  close_pores(rock, trial, closed, r);
}

/// return_fast() where it takes its common branches: compaction, retracting cap, limit surface,
/// vertex, closed pores.
/// @param outside  where a return is asked for
/// @param at_trial the meridian at the trial state
/// @param guess    gain of evp near the solution, as of a return nearby; infinity: none
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
  const MaskOf<R> beyond_tip = capped & (trial.x <= trial.cap.X);
  const MaskOf<R> compact = beyond_tip | (capped & (at_trial.slope > 0.0));
  const R reach = trial.metric * trial.q * surface.steepest;
  const MaskOf<R> to_vertex = (!capped) & (trial.x - surface.vertex >= reach);
  const MaskOf<R> wanted = outside & !to_vertex;

  // Bracket: at x = kappa_n the hardened cap's branch point is passed; at x = X there is always
  // enough dilation; the limit surface is nowhere steeper than at its vertex.
  const R last_open = rock.crush.last_open() - trial.evp;
  const R to_kappa = (trial.x - trial.cap.kappa) * per_bulk;
  const R to_X = trial.x - trial.cap.X;
  const MaskOf<R> beyond_vertex = (!capped) & (trial.x > surface.vertex);
  const R least = real::select(beyond_vertex, (trial.x - surface.vertex) * per_bulk, 0.0);
  const GainBracket<R> bracket = {
      real::select(compact, larger_of(to_kappa, last_open), least),
      real::select(compact, 0.0, real::select(capped, to_X, reach) * per_bulk)};

  // Beyond the tip the hydrostatic solution, to first order, is the better start.
  const R hydrostatic = to_X / (trial.triple_bulk + trial.cap.slope);
  const R known = real::select(beyond_tip, larger_of(hydrostatic, bracket.low), least);
  const R start = real::select((guess > bracket.low) & (guess < bracket.high), guess, known);
  const MaskOf<R> elsewhere = wanted & (start != 0.0);
  ReturnEquation<R> e{R{}, trial.x, trial.cap, at_trial};
  e.cap.present = capped;
  if (real::any(wanted & !elsewhere)) close_equation(rock, trial, compact, e);
  if (real::any(elsewhere))
    advance_points<R>(elsewhere, return_equation(rock, trial, capped, compact, start), e);

  // Pores that close altogether.
  MaskOf<R> closed = none_of<R>();
  const MaskOf<R> may_close = wanted & compact & (to_kappa < last_open);
  if (real::any(may_close)) {
    const ReturnEquation<R> nearly = return_equation(rock, trial, capped, compact, last_open);
    closed = may_close & (nearly.f <= 0.0);
  }
  const MaskOf<R> open = wanted & !closed;
  const MaskOf<R> failed = solve_return(rock, trial, capped, compact, open, bracket, e);
  ReturnedOf<R> r = returned_at(trial, e, failed);
  r.x = real::select(to_vertex, surface.vertex, r.x);
  r.q = real::select(to_vertex, 0.0, r.q);
  r.evp = real::select(to_vertex, trial.evp + least, r.evp);
  if (rock.crush.p3 == 0.0) return r;
  return_to_retracted_cap(rock, trial, MaskOf<R>(outside & !capped), r);
  close_pores(rock, trial, closed, r);
  return r;
}

}  // namespace barreno::arenisca
