// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/arenisca/bisection.hpp>
#include <cmath>

// The return of the dry law once more, for one point and without derivatives of the equation that
// it solves: what tests and benchmarks compare that of the library with (points_return.hpp).
namespace barreno::arenisca {

/// Meridian point at evp on the way back from the trial state.
struct OnTheWay {
  double x, back;  ///< back = x - x_tr [stress]
  MeridianOf<double> m;
};
template <class Crush, class Counter>
BARRENO_FUNCTION OnTheWay on_the_way(
    const YieldSurface& surface, const Crush& crush, const Trial& trial, double evp, Counter& count
) {
  const double x = trial.x - trial.triple_bulk * (evp - trial.evp);
  return {x, x - trial.x, surface.at(x, cap_with(surface, crush.strength(evp)), count)};
}

/// What the second form of the condition of the closest point (closest_point.hpp) leaves, for roots
/// without derivatives.
template <class Crush, class Counter>
struct CompactingSide {
  const YieldSurface& surface;
  const Crush& crush;
  const Trial& trial;
  Counter& count;

  /// Positive where the point lies on the elastic side of the solution (too much compaction).
  BARRENO_FUNCTION double operator()(double evp) {
    const OnTheWay w = on_the_way(surface, crush, trial, evp, count);
    if (w.m.slope <= 0.0) return w.m.cap_squared;
    const double ratio = tip_ratio(trial, w.m, w.back).value;
    return w.m.cap_squared - ratio * ratio;
  }
};

/// The first form on the dilating side (A <= 0), where the cap retracts; positive at too little
/// dilation.
template <class Crush, class Counter>
struct DilatingSide {
  const YieldSurface& surface;
  const Crush& crush;
  const Trial& trial;
  Counter& count;

  BARRENO_FUNCTION double operator()(double evp) {
    const OnTheWay w = on_the_way(surface, crush, trial, evp, count);
    return normality(trial, w.m, w.back, 0.0, {}, shear_strength<double>(w.m, {})).f;
  }
};

/// Point of the hardened surface at a solved evp; towards the tip q comes from the smooth form,
/// since Ff fc would turn the last digit of evp into the eighth of q (and the smooth form is 0/0 at
/// the top).
template <class Crush, class Counter>
BARRENO_FUNCTION Returned point_on_cap(
    const YieldSurface& surface, const Crush& crush, const Trial& trial, double evp, Counter& count
) {
  constexpr double near_tip = 0.1;
  const OnTheWay w = on_the_way(surface, crush, trial, evp, count);
  const bool at_tip = w.m.cap_squared < near_tip && w.m.slope > 0.0;
  const double q =
      at_tip ? w.m.limit * tip_ratio(trial, w.m, w.back).value : shear_strength<double>(w.m, {}).q;
  return {w.x, smaller(q, trial.q), evp};
}

/// Function values that count as zero, relative to the solution's own scale: five digits beyond the
/// 1e-9 to which the solvers agree.
constexpr double solved = 1e-14;

/// Return to the compacting side of the hardening cap.
template <class Crush, class Counter>
BARRENO_FUNCTION Returned return_by_compaction(
    const YieldSurface& surface, const Crush& crush, const Trial& trial, Counter& count
) {
  CompactingSide<Crush, Counter> side{surface, crush, trial, count};
  // At x = kappa_n the hardened cap's branch point is already passed: enough compaction there.
  BracketEnd a = {trial.evp + (trial.x - trial.cap.kappa) / trial.triple_bulk, 1.0};
  if (a.x < crush.last_open()) {
    a = {crush.last_open(), side(crush.last_open())};
    if (a.f <= 0.0) return closed_pores(surface, crush, trial);
  }
  const BracketEnd b = {trial.evp, side(trial.evp)};
  if (b.f >= 0.0) return point_on_cap(surface, crush, trial, trial.evp, count);
  const double evp = find_root(side, a, b, 1e-15 * (b.x - a.x), solved);
  return point_on_cap(surface, crush, trial, evp, count);
}

/// Root of the dilating side between the first step with enough dilation and the one before it, so
/// that of several roots (steep retraction of the cap softens) the first is taken; at x = X there
/// is always enough.
/// @param a      with too little dilation
/// @param first  first step to try, as a gain of evp
/// @param small  a function value that counts as zero
template <class Crush, class Counter>
BARRENO_FUNCTION double find_dilation(
    DilatingSide<Crush, Counter>& side, const Trial& trial, BracketEnd a, double first, double small
) {
  const double X = trial.cap.present ? trial.cap.X : side.crush.strength(a.x);
  const double farthest = trial.evp + (trial.x - X) / trial.triple_bulk;
  BracketEnd b = {farthest, 0.0};
  for (double step = first; step > 0.0 && trial.evp + step < farthest;
       step = next_dilation(step, first)) {
    if (trial.evp + step <= a.x) continue;
    const BracketEnd place = {trial.evp + step, side(trial.evp + step)};
    if (place.f < 0.0) {
      b = place;
      break;
    }
    a = place;
  }
  if (b.f == 0.0) b.f = side(b.x);
  return find_root(side, a, b, 1e-15 * (b.x - a.x), small);
}

/// Return to the cap as it retracts.
/// @param below point of the start surface straight below the trial point, dilating (slope <= 0)
template <class Crush, class Counter>
BARRENO_FUNCTION Returned return_to_retracting_cap(
    const YieldSurface& surface,
    const Crush& crush,
    const Trial& trial,
    const MeridianOf<double>& below,
    Counter& count
) {
  DilatingSide<Crush, Counter> side{surface, crush, trial, count};
  const double fc = std::sqrt(larger(below.cap_squared, 0.0));
  const BracketEnd a = {trial.evp, -trial.metric * (trial.q - below.limit * fc) * below.slope};
  if (a.f <= 0.0) return point_on_cap(surface, crush, trial, trial.evp, count);
  const double small = solved * (trial.cap.kappa - trial.cap.X);
  const double evp = find_dilation(side, trial, a, dilation_guess(trial, below), small);
  return point_on_cap(surface, crush, trial, evp, count);
}

/// Return to the limit surface or the vertex; to the cap if that retracts into the way.
template <class Crush, class Counter>
BARRENO_FUNCTION Returned return_by_dilation(
    const YieldSurface& surface, const Crush& crush, const Trial& trial, Counter& count
) {
  const double x_limit = return_to_limit(surface, trial, count);
  const double evp_limit = trial.evp + (trial.x - x_limit) / trial.triple_bulk;
  if (clears_cap(surface, crush, x_limit, evp_limit)) {
    count.add();
    const double limit = x_limit >= surface.vertex ? 0.0 : larger(surface.limit(x_limit), 0.0);
    return {x_limit, smaller(limit, trial.q), evp_limit};
  }
  DilatingSide<Crush, Counter> side{surface, crush, trial, count};
  const double start = larger(trial.evp, crush.last_open());
  const BracketEnd a = {start, side(start)};
  if (a.f <= 0.0) {
    if (!trial.cap.present) return closed_pores(surface, crush, trial);
    return point_on_cap(surface, crush, trial, start, count);
  }
  const double small = solved * std::fabs(trial.x);
  const double evp = find_dilation(side, trial, a, evp_limit - trial.evp, small);
  return point_on_cap(surface, crush, trial, evp, count);
}

/// Fast return of a trial point outside the surface (consistency and closest point in one
/// equation).
template <class Crush, class Counter>
BARRENO_FUNCTION Returned
return_fast(const YieldSurface& surface, const Crush& crush, const Trial& trial, Counter& count) {
  if (!trial.cap.present || trial.x >= trial.cap.kappa) {
    return return_by_dilation(surface, crush, trial, count);
  }
  if (trial.x <= trial.cap.X) return return_by_compaction(surface, crush, trial, count);
  // Straight below the trial point the surface's slope decides the sign of the plastic volume
  // change, with or without hardening.
  const MeridianOf<double> below = surface.at(trial.x, trial.cap, count);
  if (below.slope > 0.0) return return_by_compaction(surface, crush, trial, count);
  return return_to_retracting_cap(surface, crush, trial, below, count);
}

}  // namespace barreno::arenisca
