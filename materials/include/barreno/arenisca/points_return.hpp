// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_equation.hpp"

#include <type_traits>

namespace barreno::arenisca {

/// Where trial states come back to. `refused` where no root was found.
template <class R>
struct ReturnedOf {
  R x, q, evp;
  CapOf<R> cap;  ///< at the new evp, where the return met it
  MaskOf<R> refused;
};

template <class R>
BARRENO_FUNCTION ReturnedOf<R> returned_at(
    const TrialOf<R>& trial, const ReturnEquation<R>& e, const MaskOf<R>& refused
) {
  const R q = real::larger(e.q, 0.0);
  return {e.x, smaller_of(q, trial.q), trial.evp + e.gain, e.cap, refused};
}

/// Pores close altogether, where `closed` (closest_point.hpp): no cap is left.
template <class R, class Law>
BARRENO_FUNCTION void close_pores(
    const Law& rock, const TrialOf<R>& trial, const MaskOf<R>& closed, ReturnedOf<R>& r
) {
  if (!real::any(closed)) return;
  const ClosedOf<R> c = return_with_closed_pores(rock.surface, rock.crush.closed(), trial);
  r.x = real::select(closed, c.x, r.x);
  r.q = real::select(closed, c.q, r.q);
  r.evp = real::select(closed, c.evp, r.evp);
  r.cap.present = r.cap.present & !closed;
  r.refused = r.refused & !closed;
}

/// Brackets the first root of the way on which closed pores open, see next_dilation(). At x = X
/// there is always enough dilation.
/// @param opens where it is asked for; there e is at the least dilation, with too little of it
/// @param first gain of evp to try first
/// @param[in,out] e the equation at the lower end of the bracket
template <class R, class Law>
BARRENO_FUNCTION void find_dilation(
    const Law& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& capped,
    const MaskOf<R>& opens,
    const R& first,
    GainBracket<R>& bracket,
    ReturnEquation<R>& e
) {
  constexpr int max_steps = 200;
  const MaskOf<R> compacting = none_of<R>();
  const R farthest = (trial.x - e.cap.X) / trial.triple_bulk;
  bracket.low = real::select(opens, e.gain, bracket.low);
  bracket.high = real::select(opens, farthest, bracket.high);
  R step = first;
  MaskOf<R> open = opens & (step > 0.0) & (step < farthest);
  for (int i = 0; i < max_steps && real::any(open); ++i) {
    const ReturnEquation<R> there = return_equation(rock, trial, capped, compacting, step);
    const MaskOf<R> ahead = open & (step > bracket.low);
    const MaskOf<R> enough = ahead & (there.f < 0.0);
    const MaskOf<R> too_little = ahead & !enough;
    bracket.high = real::select(enough, step, bracket.high);
    bracket.low = real::select(too_little, step, bracket.low);
    advance_points<R>(too_little, there, e);
    step = next_dilation(step, first);
    open = open & (!enough) & (step < farthest);
  }
}

/// Whether the cap has retracted into the way of a return to the limit surface or the vertex.
/// @param limited where the return went there
template <class R, class Law>
BARRENO_FUNCTION MaskOf<R> caught_by_cap(
    const Law& rock, const TrialOf<R>& trial, const MaskOf<R>& limited, const ReturnedOf<R>& r
) {
  MaskOf<R> unclear = limited;
  if constexpr (is_concave<std::decay_t<decltype(rock.crush)>>) {
    // The tangent tells most that clear the cap.
    const R bound = trial.cap.kappa + rock.surface.CR * trial.cap.slope * (r.evp - trial.evp);
    unclear = limited & !(trial.cap.present & (r.x >= bound));
  }
  if (!real::any(unclear)) return none_of<R>();
  const CapOf<R> end = cap_of(rock, R(real::larger(r.evp, rock.crush.last_open())));
  return unclear & (r.x < end.kappa);
}

/// Where a return to the limit surface or the vertex finds that the cap has retracted into the way:
/// return to that cap.
/// @param limited where the return went to the limit surface or the vertex
template <class R, class Law>
BARRENO_FUNCTION void return_to_retracted_cap(
    const Law& rock, const TrialOf<R>& trial, const MaskOf<R>& limited, ReturnedOf<R>& r
) {
  const double last_open = rock.crush.last_open();
  const MaskOf<R> caught = caught_by_cap(rock, trial, limited, r);
  if (!real::any(caught)) return;
  // First guess: where the cap's branch point meets the elastic path; closed pores begin to open.
  const R to_branch =
      (trial.x - trial.cap.kappa) / (trial.triple_bulk + rock.surface.CR * trial.cap.slope);
  const R least = real::larger(R(last_open - trial.evp), 0.0);
  const R start = real::select(trial.cap.present, to_branch, least);
  const MaskOf<R> compacting = none_of<R>();
  ReturnEquation<R> e = return_equation(rock, trial, caught, compacting, start);
  const MaskOf<R> opening = caught & !trial.cap.present;
  const MaskOf<R> closed = opening & (e.f <= 0.0);
  const MaskOf<R> open = caught & !closed;
  GainBracket<R> bracket{R{}, (trial.x - trial.cap.X) / trial.triple_bulk};
  const MaskOf<R> opens = opening & !closed;
  if (real::any(opens)) find_dilation(rock, trial, caught, opens, R(r.evp - trial.evp), bracket, e);
  const MaskOf<R> failed = solve_return(rock, trial, caught, compacting, open, bracket, e);
  const ReturnedOf<R> onto = returned_at(trial, e, failed);
  const MaskOf<R> refused = r.refused | failed;
  assign_where(open, onto, r);
  r.refused = refused;
  close_pores(rock, trial, closed, r);
}

/// On which side of the surface a return is searched, and between which gains of evp.
template <class R>
struct ReturnSearch {
  MaskOf<R> capped, beyond_tip, compacting, to_vertex;
  R reach;                ///< I1 beyond the vertex from which all goes there [stress]
  R last_open, to_kappa;  ///< gains: pores closed, the cap's branch point passed
  R least;                ///< gain that brings the point to the vertex' pressure, or none
  GainBracket<R> bracket;
};
/// @param at_trial the meridian at the trial state
template <class R, class Law>
BARRENO_FUNCTION ReturnSearch<R> search_of(
    const Law& rock, const TrialOf<R>& trial, const MeridianOf<R>& at_trial
) {
  const auto& surface = rock.surface;
  const R per_bulk = 1.0 / trial.triple_bulk;
  ReturnSearch<R> s;
  s.capped = trial.cap.present & (trial.x < trial.cap.kappa);
  s.beyond_tip = s.capped & (trial.x <= trial.cap.X);
  s.compacting = s.beyond_tip | (s.capped & (at_trial.slope > 0.0));
  s.reach = trial.metric * trial.q * surface.steepest;
  s.to_vertex = (!s.capped) & (trial.x - surface.vertex >= s.reach);
  // At x = kappa_n the hardened cap's branch point is passed; at x = X there is always enough
  // dilation; the limit surface is nowhere steeper than at its vertex.
  s.last_open = rock.crush.last_open() - trial.evp;
  s.to_kappa = (trial.x - trial.cap.kappa) * per_bulk;
  const R to_X = trial.x - trial.cap.X;
  const MaskOf<R> beyond_vertex = (!s.capped) & (trial.x > surface.vertex);
  s.least = real::select(beyond_vertex, (trial.x - surface.vertex) * per_bulk, 0.0);
  s.bracket = {
      real::select(s.compacting, larger_of(s.to_kappa, s.last_open), s.least),
      real::select(s.compacting, 0.0, real::select(s.capped, to_X, s.reach) * per_bulk)};
  return s;
}
/// The gain of evp to begin with.
/// @param guess  infinity: none
template <class R>
BARRENO_FUNCTION R
start_of_return(const TrialOf<R>& trial, const ReturnSearch<R>& search, const R& guess) {
  const GainBracket<R>& bracket = search.bracket;
  // Beyond the tip the hydrostatic solution, to first order, is the better start.
  const R hydrostatic = (trial.x - trial.cap.X) / (trial.triple_bulk + trial.cap.slope);
  const R known =
      real::select(search.beyond_tip, larger_of(hydrostatic, bracket.low), search.least);
  return real::select((guess > bracket.low) & (guess < bracket.high), guess, known);
}

/// Consistency and closest point in one equation: compaction, retracting cap, limit surface,
/// vertex, closed pores.
/// @param outside  where a return is asked for
/// @param at_trial the meridian at the trial state
/// @param guess    gain of evp near the solution, as of a return nearby; infinity: none
template <class R, class Law>
BARRENO_FUNCTION ReturnedOf<R> return_points(
    const Law& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const R& guess
) {
  const ReturnSearch<R> search = search_of(rock, trial, at_trial);
  const MaskOf<R> capped = search.capped, compacting = search.compacting;
  const GainBracket<R>& bracket = search.bracket;
  const MaskOf<R> wanted = outside & !search.to_vertex;

  const R start = start_of_return(trial, search, guess);
  const MaskOf<R> elsewhere = wanted & (start != 0.0);
  ReturnEquation<R> e{R{}, trial.x, trial.cap, at_trial};
  e.cap.present = capped;
  if (real::any(wanted & !elsewhere)) close_equation(rock, trial, compacting, e);
  if (real::any(elsewhere))
    advance_points<R>(elsewhere, return_equation(rock, trial, capped, compacting, start), e);

  // Pores that close altogether.
  MaskOf<R> closed = none_of<R>();
  const MaskOf<R> may_close = wanted & compacting & (search.to_kappa < search.last_open);
  if (real::any(may_close)) {
    const ReturnEquation<R> nearly =
        return_equation(rock, trial, capped, compacting, search.last_open);
    closed = may_close & (nearly.f <= 0.0);
  }
  const MaskOf<R> open = wanted & !closed;
  const MaskOf<R> failed = solve_return(rock, trial, capped, compacting, open, bracket, e);
  ReturnedOf<R> r = returned_at(trial, e, failed);
  r.x = real::select(search.to_vertex, R(R{} + rock.surface.vertex), r.x);
  r.q = real::select(search.to_vertex, 0.0, r.q);
  r.evp = real::select(search.to_vertex, trial.evp + search.least, r.evp);
  if (!rock.crush.porous()) return r;
  return_to_retracted_cap(rock, trial, MaskOf<R>(outside & !capped), r);
  close_pores(rock, trial, closed, r);
  return r;
}

}  // namespace barreno::arenisca
